#pragma once
// Where four squares meet, two dark and two light: around such a point brightness turns twice, so the second
// harmonic of the angle holds nearly all of its variance (8 / pi^2 for an ideal one), whatever its direction,
// exposure and contrast. Edges, blobs and bends have other harmonics. Pure.

#include <vector>

#include "algorithms/calibration/ground_picture.h"

namespace svchain::calibration {

struct SaddlePoint {
  Eigen::Vector2d ground_m;  // by the ground picture's pose
  double dark_axis_rad = 0;  // direction of the dark quarters in the vehicle's frame, modulo pi
  double strength = 0;       // share of the second harmonic, 0 to 1
};

/// Saddles whose squares are about `kSidePx` wide, strongest first.
std::vector<SaddlePoint> find_saddles(const GroundPicture& picture);

}  // namespace svchain::calibration
