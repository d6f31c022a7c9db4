#pragma once
// The candidates of one overlap that agree on one and the same correction of its two cameras. RANSAC with
// what is known of the start: three candidates and the prior give the most probable correction, linearly;
//   x = -S J' (J S J' + noise^2)^-1 r,  S the prior's covariance, J and r of the three;
// the best is the one that most corners agree with, less what it strains the prior. Pure; the same input
// gives the same answer.

#include <Eigen/Core>
#include <vector>

#include "algorithms/registration/disagreement.h"

namespace svchain::registration {

/// A candidate with its disagreement at the start. Candidates of one corner carry the same number.
struct LinearPair {
  size_t corner = 0;
  Disagreement disagreement;
};

using PairCovariance = Eigen::Matrix<double, 16, 16>;  // of the steps of both cameras

/// Indices of the candidates that agree, at most one for each corner. Empty where they are so few that chance
/// explains them.
std::vector<size_t> consensus(const std::vector<LinearPair>& pairs, const PairCovariance& prior,
                              double noise_m);

}  // namespace svchain::registration
