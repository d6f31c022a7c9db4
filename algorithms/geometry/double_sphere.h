#pragma once
// The double sphere model (Usenko, Demmel, Cremers, 3DV 2018): a point (x, y, z) of length d1 goes to (x, y)
// / (alpha d2 + (1 - alpha) (xi d1 + z)) with d2 = sqrt(x^2 + y^2 + (xi d1 + z)^2), times the focal lengths.
// On a ray of length 1 that is r = sin t / n, n = alpha d2 + (1 - alpha) (xi + cos t), and dr/dt = (1 + xi
// cos t) (alpha (xi + cos t) / d2 + 1 - alpha) / n^2. Valid while r rises and n is at least kLeastDepth of
// what it is on the axis.

#include "algorithms/geometry/radial_lens.h"

namespace svchain::geometry {

struct DoubleSphereCurve {
  static constexpr const char* kModel = "double_sphere";
  double xi;     // above -1
  double alpha;  // 0..1
  double radius(double angle_rad) const;
  double slope(double angle_rad) const;
};

using DoubleSphere = RadialLens<DoubleSphereCurve>;

}  // namespace svchain::geometry
