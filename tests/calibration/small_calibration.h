#pragma once
// What a calibration came to, made up.

#include "algorithms/calibration/calibration.h"

namespace svchain::testing {

/// Of a car's rig that is scaled to this length, with one chart of 12 corners, and a corner of each state in
/// front's picture, 20 px apart from (300, 200) on, predicted 3 px to the right of where it was found.
calibration::Calibration small_calibration(double vehicle_length_m = 4.8);

}  // namespace svchain::testing
