#pragma once
// The radial polynomial of the WoodScape data set (Yogamani et al., ICCV 2019): r = k1 t + k2 t^2 + k3 t^3 +
// k4 t^4 in px, t the angle from the optical axis; u = r a + cx, v = aspect r b + cy. Its `focal_px` is
// (1, aspect). Valid as far as r rises, from the axis on.

#include <array>

#include "algorithms/geometry/radial_lens.h"

namespace svchain::geometry {

struct PolynomialCurve {
  static constexpr const char* kModel = "polynomial";
  std::array<double, 4> k_px;
  double radius(double angle_rad) const;
  double slope(double angle_rad) const;
};

using Polynomial = RadialLens<PolynomialCurve>;

}  // namespace svchain::geometry
