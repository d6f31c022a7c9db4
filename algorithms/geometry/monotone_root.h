#pragma once
// The one place where a rising function takes a value. Pure, allocates nothing.

#include <cmath>

namespace svchain::geometry {

/// x in [low, high] with f(x) = target, for f rising from f(low) <= target to f(high) >= target. Newton's
/// steps from `start`, and a halving of the bracket wherever a step would leave it or the slope is of no
/// help.
template <class Function, class Slope>
double monotone_root(Function f, Slope slope, double target, double low, double high, double start) {
  constexpr int kMostSteps = 80;
  constexpr double kClose = 1e-15;  // of x, in relation to the largest x
  const double close = kClose * (std::abs(low) + std::abs(high));
  double x = start;
  for (int step = 0; step < kMostSteps && high - low > close; ++step) {
    const double error = f(x) - target;
    if (error == 0) return x;
    (error > 0 ? high : low) = x;
    const double newton = x - error / slope(x);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - x) <= close) return next;
    x = next;
  }
  return x;
}

}  // namespace svchain::geometry
