#pragma once
// The enhanced unified camera model (Khomutenko, Garcia, Martinet, IEEE RA-L 1(1), 2016): a point (x, y, z)
// goes to (x, y) / (alpha sqrt(beta (x^2 + y^2) + z^2) + (1 - alpha) z), times the focal lengths. On a ray of
// length 1 that is r = sin t / n, n = alpha d + (1 - alpha) cos t, d = sqrt(beta sin^2 t + cos^2 t), and
// dr/dt = (alpha cos t / d + 1 - alpha) / n^2. Valid while r rises and n is at least kLeastDepth.

#include "algorithms/geometry/radial_lens.h"

namespace svchain::geometry {

struct EucmCurve {
  static constexpr const char* kModel = "eucm";
  double alpha;  // 0..1; 0 is a pinhole
  double beta;   // above 0
  double radius(double angle_rad) const;
  double slope(double angle_rad) const;
};

using Eucm = RadialLens<EucmCurve>;

}  // namespace svchain::geometry
