#pragma once
// Brown's distortion of a plane, radial and tangential, with OpenCV's signs and order k1, k2, p1, p2, k3:
//   x' = x q + 2 p1 x y + p2 (r^2 + 2 x^2),  y' = y q + p1 (r^2 + 2 y^2) + 2 p2 x y,
//   q = 1 + k1 r^2 + k2 r^4 + k3 r^6,  r^2 = x^2 + y^2.
// Plain value; pure functions.

#include <Eigen/Core>
#include <array>
#include <optional>

namespace svchain::geometry {

struct BrownDistortion {
  std::array<double, 5> k;  // k1, k2, p1, p2, k3

  Eigen::Vector2d distort(const Eigen::Vector2d& point) const;
  Eigen::Matrix2d jacobian(const Eigen::Vector2d& point) const;
  /// The point that is distorted to this one, by Newton's method. Nothing where none is found within a few
  /// times `reach`, the radius inside which the distortion is known to be one to one.
  std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& distorted, double reach) const;
};

}  // namespace svchain::geometry
