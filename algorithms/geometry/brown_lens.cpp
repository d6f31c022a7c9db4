#include "algorithms/geometry/brown_lens.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/geometry/off_axis.h"
#include "algorithms/geometry/served_range.h"

namespace svchain::geometry {

BrownLens::BrownLens(double xi, Eigen::Vector2d focal_px, Eigen::Vector2d centre_px,
                     BrownDistortion distortion, double max_angle_rad)
    : xi_(xi),
      focal_px_(focal_px),
      centre_px_(centre_px),
      distortion_(distortion),
      max_angle_rad_(last_served([this](double t) { return serves(t); }, max_angle_rad)),
      max_plane_radius_(plane_radius(max_angle_rad_)) {}

double BrownLens::plane_radius(double angle_rad) const {
  return std::sin(angle_rad) / (std::cos(angle_rad) + xi_);
}

bool BrownLens::serves(double angle_rad) const {
  const double c = std::cos(angle_rad);
  if (c + xi_ < kLeastDepth * (1 + xi_)) return false;
  if (1 + xi_ * c <= 0) return false;  // r has turned: dr/dt = (1 + xi cos t) / (cos t + xi)^2
  constexpr int kDirections = 64;
  const double r = plane_radius(angle_rad);
  for (int i = 0; i < kDirections; ++i) {
    const double azimuth = 2 * std::numbers::pi * i / kDirections;
    const auto j = distortion_.jacobian({r * std::cos(azimuth), r * std::sin(azimuth)});
    // Symmetric: with these two above 0 the distortion is one to one as far as here.
    if (!(j.determinant() > 0 && j.trace() > 0)) return false;
  }
  return true;
}

std::optional<Eigen::Vector2d> BrownLens::project(const Eigen::Vector3d& ray) const {
  const auto seen = off_axis(ray, max_angle_rad_);
  if (!seen) return std::nullopt;
  if (seen->across == 0) return centre_px_;
  const Eigen::Vector2d plane = ray.head<2>() * (plane_radius(seen->angle_rad) / seen->across);
  return Eigen::Vector2d(distortion_.distort(plane).cwiseProduct(focal_px_) + centre_px_);
}

std::optional<Eigen::Vector3d> BrownLens::unproject(const Eigen::Vector2d& pixel) const {
  const auto plane = distortion_.undistort((pixel - centre_px_).cwiseQuotient(focal_px_), max_plane_radius_);
  if (!plane) return std::nullopt;
  const double r = plane->norm();
  if (!(r <= max_plane_radius_ * (1 + kAngleSlackRad))) return std::nullopt;
  if (r == 0) return Eigen::Vector3d::UnitZ();
  // sin t = r (cos t + xi), that is sin(t - atan r) = xi sin(atan r). Where r turns the right side reaches 1.
  const double tilt = std::atan(r);
  const double angle =
      std::min(tilt + std::asin(std::clamp(xi_ * std::sin(tilt), -1.0, 1.0)), max_angle_rad_);
  const double across = std::sin(angle) / r;
  return Eigen::Vector3d(across * plane->x(), across * plane->y(), std::cos(angle));
}

}  // namespace svchain::geometry
