#include "algorithms/geometry/kannala_brandt.h"

namespace svchain::geometry {

double KannalaBrandtCurve::radius(double t) const {
  const double t2 = t * t;
  return t * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
}

double KannalaBrandtCurve::slope(double t) const {
  const double t2 = t * t;
  return 1 + t2 * (3 * k[0] + t2 * (5 * k[1] + t2 * (7 * k[2] + t2 * 9 * k[3])));
}

}  // namespace svchain::geometry
