#include "algorithms/geometry/double_sphere.h"

#include <cmath>

namespace svchain::geometry {

double DoubleSphereCurve::radius(double t) const {
  const double s = std::sin(t), shifted = xi + std::cos(t);
  return s / (alpha * std::hypot(s, shifted) + (1 - alpha) * shifted);
}

double DoubleSphereCurve::slope(double t) const {
  const double s = std::sin(t), c = std::cos(t), shifted = xi + c;
  const double d2 = std::hypot(s, shifted);
  const double depth = alpha * d2 + (1 - alpha) * shifted;
  if (depth < kLeastDepth * (1 + xi)) return 0;
  return (1 + xi * c) * (alpha * shifted / d2 + 1 - alpha) / (depth * depth);
}

}  // namespace svchain::geometry
