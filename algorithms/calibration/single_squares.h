#pragma once
// Dark squares that stand alone on light ground, as contours of a picture laid on the ground. Pure.

#include <array>
#include <vector>

#include "algorithms/calibration/ground_picture.h"

namespace svchain::calibration {

/// Corners on the ground, counter-clockwise seen from above, any of them first.
using GroundSquare = std::array<Eigen::Vector2d, 4>;

/// Squares of about `kSidePx` in the picture.
std::vector<GroundSquare> find_single_squares(const GroundPicture& picture);

}  // namespace svchain::calibration
