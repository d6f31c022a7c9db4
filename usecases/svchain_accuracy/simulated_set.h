#pragma once
// One simulated set of pictures, calibrated in every way that is compared, against its truth. Pure: the same
// arguments give the same figures.

#include <string>

#include "usecases/svchain_accuracy/pose_error.h"

namespace svchain::accuracy {

struct Outcome {
  bool accepted = false;
  std::string reasons;  // why it is not, one line
  PoseError worst;      // over the cameras
};

struct SimulatedSet {
  std::string vehicle;  // "car" or "toy"
  std::string lens_model;
  uint64_t seed = 0;
};

struct SetResult {
  SimulatedSet set;
  Outcome posed;                    // calibrate(), the charts' places given
  Outcome unposed;                  // their places not given; after the best common motion, sigmas before it
  double unposed_sigmas_moved = 0;  // errors after that motion in stated sigmas
  PoseError refined;                // baselines (plain_calibration.h), given places
  double homography_ground_mm = 0;
};

/// Throws std::runtime_error where the shipped scenes cannot be read.
SetResult measure(const SimulatedSet& set);

/// One line that says it all.
std::string text_of(const SetResult& result);

}  // namespace svchain::accuracy
