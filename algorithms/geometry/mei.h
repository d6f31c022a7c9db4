#pragma once
// The unified model with distortion of Mei and Rives (ICRA 2007), Kalibr's `omni`: a point on the unit sphere
// is seen from xi behind its centre, (x, y) / (z + xi), then Brown's distortion k1, k2, p1, p2, then the
// focal lengths (their gamma) and the centre. See brown_lens.h for how far it is valid.

#include "algorithms/geometry/brown_lens.h"

namespace svchain::geometry {

class Mei : public BrownLens {
 public:
  Mei(double xi, Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, std::array<double, 4> k,
      double max_angle_rad = kUsualMaxAngleRad)
      : BrownLens(xi, focal_px, centre_px, {{k[0], k[1], k[2], k[3], 0}}, max_angle_rad) {}

  std::string model() const override { return "mei"; }
  using BrownLens::xi;
  std::array<double, 4> k() const {
    const auto& all = distortion().k;
    return {all[0], all[1], all[2], all[3]};
  }
};

}  // namespace svchain::geometry
