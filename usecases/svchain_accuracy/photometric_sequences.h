#pragma once
// Photometric alignment over many frames of a simulated car park. Pure functions.

namespace svchain::accuracy {

struct ExposureStep {
  int frames_to_settle = 0;  // after a camera becomes 1.5 stops darker
  double largest_move = 0;   // of the composite's mean from frame to frame once settled, grey levels
};
ExposureStep measure_exposure_step();

/// The largest change of any entry of any curve while somebody crosses an overlap.
double measure_crossing();

/// The largest distance of any entry of any curve from the identity when all cameras are alike.
double measure_equal_cameras();

}  // namespace svchain::accuracy
