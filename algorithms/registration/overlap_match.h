#pragma once
// The features that two neighbours have in common in their overlap: Harris, BRIEF, candidates, consensus and,
// where asked for, the last hundredths of a pixel. Pure but for the clock it is given.

#include <array>
#include <vector>

#include "algorithms/geometry/view.h"
#include "algorithms/registration/consensus.h"
#include "algorithms/registration/ground_picture.h"
#include "algorithms/registration/joint_fit.h"
#include "algorithms/registration/stage_clock.h"

namespace svchain::registration {

/// What is known when overlaps are matched: the frames, the matrices as they are now (`starts` and `steps`),
/// and how far these may still be off.
struct Knowledge {
  std::array<Pyramid, 4> frames;
  std::array<GroundCamera, 4> cameras;  // with the matrices as they are now
  geometry::Vehicle vehicle;
  geometry::View view;
  Perspectives starts;
  Steps steps;
  JointCovariance covariance;

  PairCovariance covariance_of(size_t a, size_t b) const;
};

struct Fineness {
  double metres_per_px = 0;
  size_t alternatives = 1;  // that a corner keeps
  bool patches = false;     // whether places are refined to fractions of a pixel
};

/// A feature that both cameras show: where in their images, and the rays there.
struct Feature {
  Eigen::Vector2d pixel_a;
  Eigen::Vector2d pixel_b;
  RayPair rays;
};

struct OverlapFeatures {
  size_t corners_a = 0;
  size_t corners_b = 0;
  size_t candidates = 0;
  std::vector<Feature> features;  // strongest first
};

/// Of cameras `a` and the next one clockwise.
OverlapFeatures match_overlap(const Knowledge& knowledge, size_t a, const Fineness& fineness,
                              StageClock& clock);

}  // namespace svchain::registration
