#pragma once
// How good a calibration is, and by which limits it is accepted or rejected. Pure.

#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/seen_corners.h"

namespace svchain::calibration {

/// Beyond these a calibration is rejected. Lengths are for a car and shrink with a smaller vehicle.
struct AcceptanceLimits {
  int least_inliers = 8;
  double least_inlier_share = 0.6;
  double most_rms_px = 1.0;
  double most_ground_sigma_near_cm = 2;
  double most_ground_sigma_far_cm = 6;
  double most_ground_rms_cm = 5;
  double most_overlap_rms_cm = 5;
  double most_turn_from_nominal = 4;   // in the nominal poses' tolerance
  double most_shift_from_nominal = 4;  // likewise
  double most_lens_change_px = 12;
};

/// Lengths of a vehicle relative to the car that limits and tolerances are stated for.
double scale_of(const geometry::Vehicle& vehicle);

/// Accuracies by the corners that are `held_out` (or, where none is, by all), reasons among them.
void judge(const CalibrationInput& input, const FittedEstimate& fitted,
           const std::vector<SeenCorner>& corners, const std::vector<ChartPattern>& patterns,
           const AcceptanceLimits& limits, Calibration& calibration);

}  // namespace svchain::calibration
