#include "algorithms/geometry/polynomial.h"

namespace svchain::geometry {

double PolynomialCurve::radius(double t) const {
  return t * (k_px[0] + t * (k_px[1] + t * (k_px[2] + t * k_px[3])));
}

double PolynomialCurve::slope(double t) const {
  return k_px[0] + t * (2 * k_px[1] + t * (3 * k_px[2] + t * 4 * k_px[3]));
}

}  // namespace svchain::geometry
