#pragma once
// Perspective with Brown's distortion k1, k2, p1, p2, k3 as OpenCV's `calibrateCamera` gives it: (x, y) / z,
// distorted, times the focal lengths, plus the centre. Used up to 80 degrees at most.

#include <algorithm>

#include "algorithms/geometry/brown_lens.h"

namespace svchain::geometry {

class Pinhole : public BrownLens {
 public:
  static constexpr double kLimitRad = radians(80);

  Pinhole(Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, std::array<double, 5> k,
          double max_angle_rad = kLimitRad)
      : BrownLens(0, focal_px, centre_px, {k}, std::min(max_angle_rad, kLimitRad)) {}

  std::string model() const override { return "pinhole"; }
  const std::array<double, 5>& k() const { return distortion().k; }
};

}  // namespace svchain::geometry
