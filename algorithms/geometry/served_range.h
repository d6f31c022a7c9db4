#pragma once
// How far from its axis a lens model serves. Pure, allocates nothing.

namespace svchain::geometry {

/// A model that divides by a depth is used while that is at least this part of the depth on the axis: what a
/// pinhole has at a little over 80 degrees. Beyond, pixels run away to infinity.
inline constexpr double kLeastDepth = 0.17;

/// The largest angle up to `limit_rad` such that `serves(angle)` holds all the way from the axis.
template <class Predicate>
double last_served(Predicate serves, double limit_rad) {
  constexpr int kSteps = 256;  // finer than any lens wiggles
  double served = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = limit_rad * i / kSteps;
    if (serves(angle)) {
      served = angle;
      continue;
    }
    double beyond = angle;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (served + beyond);
      (serves(middle) ? served : beyond) = middle;
    }
    return served;
  }
  return limit_rad;
}

}  // namespace svchain::geometry
