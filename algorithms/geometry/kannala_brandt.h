#pragma once
// The fisheye model of Kannala and Brandt (IEEE PAMI 28(8), 2006), radial part, as OpenCV's `fisheye` has it:
// r = t + k1 t^3 + k2 t^5 + k3 t^7 + k4 t^9 with t the angle from the optical axis, u = fx r a + cx, v = fy r
// b + cy with (a, b) the unit direction of the ray's (x, y). Valid beyond 90 degrees, as far as r rises.
// Immutable.

#include <array>

#include "algorithms/geometry/radial_lens.h"

namespace svchain::geometry {

struct KannalaBrandtCurve {
  static constexpr const char* kModel = "kannala_brandt";
  std::array<double, 4> k;
  double radius(double angle_rad) const;
  double slope(double angle_rad) const;
};

class KannalaBrandt : public RadialLens<KannalaBrandtCurve> {
 public:
  /// The largest angle is cut down to the first turning point of r where that is smaller.
  KannalaBrandt(Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, std::array<double, 4> k,
                double max_angle_rad = kUsualMaxAngleRad)
      : RadialLens({k}, focal_px, centre_px, max_angle_rad) {}

  const std::array<double, 4>& k() const { return curve().k; }
};

}  // namespace svchain::geometry
