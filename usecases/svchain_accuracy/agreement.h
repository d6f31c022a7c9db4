#pragma once
// How well a rig agrees with corners that real cameras saw, where no truth is known but the charts': of each
// camera where it puts corners on the ground, of each pair of neighbours whether they put them at the same
// place. Pure functions.

#include <array>
#include <cmath>
#include <vector>

#include "algorithms/calibration/calibration.h"

namespace svchain::accuracy {

/// Sizes of errors.
class Errors {
 public:
  void add(double error) { sizes_.push_back(std::abs(error)); }
  int count() const { return static_cast<int>(sizes_.size()); }
  double rms() const;
  double median() const;

 private:
  std::vector<double> sizes_;
};

struct Agreement {
  std::array<Errors, 4> pair_cm;    // camera c and its clockwise neighbour: the same corner by both
  std::array<Errors, 4> ground_cm;  // corners of charts that have a place, against it
  std::array<Errors, 4> across_cm;  // the part of that across the line of sight
  int rejected = 0;                 // corners left out since the calibration calls them outliers
};

/// Adds the corners held out of a calibration, as `rig` (calibrated by whomever) explains them.
void add_held_out(const calibration::Calibration& made, const geometry::Rig& rig,
                  calibration::HoldOut hold_out, Agreement& agreement);

/// Two calibrations, each fitted on one half of the corners, and how they agree with the other halves.
struct HeldOutResult {
  std::array<calibration::Calibration, 2> made;  // without even corners, without odd ones
  Agreement ours;
  Agreement given;  // the rig that it started from, by the same corners
};
HeldOutResult hold_out_in_turn(calibration::CalibrationInput input);

}  // namespace svchain::accuracy
