#include "algorithms/geometry/eucm.h"

#include <cmath>

namespace svchain::geometry {

double EucmCurve::radius(double t) const {
  const double s = std::sin(t), c = std::cos(t);
  return s / (alpha * std::sqrt(beta * s * s + c * c) + (1 - alpha) * c);
}

double EucmCurve::slope(double t) const {
  const double s = std::sin(t), c = std::cos(t);
  const double d = std::sqrt(beta * s * s + c * c);
  const double depth = alpha * d + (1 - alpha) * c;
  if (depth < kLeastDepth) return 0;
  return (alpha * c / d + 1 - alpha) / (depth * depth);
}

}  // namespace svchain::geometry
