#include "algorithms/geometry/brown_distortion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "algorithms/geometry/monotone_root.h"

namespace svchain::geometry {

Eigen::Vector2d BrownDistortion::distort(const Eigen::Vector2d& point) const {
  const auto [k1, k2, p1, p2, k3] = k;
  const double x = point.x(), y = point.y();
  const double r2 = point.squaredNorm();
  const double q = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * q + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), y * q + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

Eigen::Matrix2d BrownDistortion::jacobian(const Eigen::Vector2d& point) const {
  const auto [k1, k2, p1, p2, k3] = k;
  const double x = point.x(), y = point.y();
  const double r2 = point.squaredNorm();
  const double q = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double dq = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));  // dq/dx = x dq, dq/dy = y dq
  const double mixed = x * y * dq + 2 * (p1 * x + p2 * y);
  Eigen::Matrix2d j;
  j << q + x * x * dq + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, q + y * y * dq + 6 * p1 * y + 2 * p2 * x;
  return j;
}

std::optional<Eigen::Vector2d> BrownDistortion::undistort(const Eigen::Vector2d& distorted,
                                                          double reach) const {
  const auto [k1, k2, p1, p2, k3] = k;
  const double r = distorted.norm();
  if (r == 0) return Eigen::Vector2d::Zero();
  if (!std::isfinite(r)) return std::nullopt;
  // The radial part alone tells where to begin.
  const auto radial = [&](double x) { return x * (1 + x * x * (k1 + x * x * (k2 + x * x * k3))); };
  const auto slope = [&](double x) { return 1 + x * x * (3 * k1 + x * x * (5 * k2 + x * x * 7 * k3)); };
  const double start = monotone_root(radial, slope, r, 0, reach, std::min(r, reach));
  Eigen::Vector2d point = distorted * (start / r);
  Eigen::Vector2d error = distort(point) - distorted;

  constexpr int kMostSteps = 60;
  constexpr double kClose = 1e-13;
  constexpr double kAstray = 4;  // times the reach
  for (int step = 0; step < kMostSteps && error.norm() > kClose * (1 + r); ++step) {
    const Eigen::Vector2d newton = jacobian(point).inverse() * error;
    if (!newton.allFinite()) return std::nullopt;
    double part = 1;
    Eigen::Vector2d next = point - newton;
    Eigen::Vector2d next_error = distort(next) - distorted;
    while (!(next_error.norm() < error.norm()) && part > 1e-3) {
      part /= 2;
      next = point - part * newton;
      next_error = distort(next) - distorted;
    }
    if (!(next_error.norm() < error.norm()) || next.norm() > kAstray * reach) break;
    point = next;
    error = next_error;
  }
  constexpr double kFound = 1e-11;
  if (!(error.norm() <= kFound * (1 + r))) return std::nullopt;
  return point;
}

}  // namespace svchain::geometry
