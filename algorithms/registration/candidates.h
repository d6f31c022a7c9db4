#pragma once
// Which corners of one camera may be which of another: near enough and alike. On charts many are alike, so
// each corner keeps several; the geometry tells them apart later (consensus.h). Pure.

#include <Eigen/Core>
#include <vector>

#include "algorithms/registration/brief.h"

namespace svchain::registration {

struct Corners {
  std::vector<Eigen::Vector2d> grounds;  // where their camera's matrix puts them, metres
  std::vector<Descriptor> descriptors;
};

struct Candidate {
  size_t in_a = 0;
  size_t in_b = 0;
};

/// Pairs of corners of which each is among the `alternatives` most alike to the other, of those that its
/// window holds. The window of a corner of `a` is the ellipse of three standard deviations of `windows`, the
/// covariance (m^2) of where its like may lie in `b`.
std::vector<Candidate> candidates(const Corners& a, const Corners& b,
                                  const std::vector<Eigen::Matrix2d>& windows, size_t alternatives);

}  // namespace svchain::registration
