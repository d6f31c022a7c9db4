#include "algorithms/geometry/ocam.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/geometry/monotone_root.h"
#include "algorithms/geometry/off_axis.h"
#include "algorithms/geometry/served_range.h"

namespace svchain::geometry {

namespace {

Eigen::Matrix2d columns_and_rows(const Eigen::Vector3d& affine) {
  Eigen::Matrix2d m;
  m << 1, affine[2],  //
      affine[1], affine[0];
  return m;
}

}  // namespace

Ocam::Ocam(std::vector<double> inverse_polynomial, Eigen::Vector3d affine, Eigen::Vector2d centre_row_column,
           double max_angle_rad)
    : inverse_polynomial_(std::move(inverse_polynomial)),
      affine_(affine),
      centre_row_column_(centre_row_column),
      centre_px_(centre_row_column.y(), centre_row_column.x()),
      pixel_from_plane_(columns_and_rows(affine)),
      plane_from_pixel_(pixel_from_plane_.inverse()),
      max_angle_rad_(last_served([this](double t) { return radius_slope(t) > 0; }, max_angle_rad)),
      max_radius_px_(radius_px(max_angle_rad_)) {}

double Ocam::radius_px(double angle_rad) const {
  const double theta = angle_rad - std::numbers::pi / 2;
  double sum = 0;
  for (size_t i = inverse_polynomial_.size(); i-- > 0;) sum = sum * theta + inverse_polynomial_[i];
  return sum;
}

double Ocam::radius_slope(double angle_rad) const {
  const double theta = angle_rad - std::numbers::pi / 2;
  double sum = 0;
  for (size_t i = inverse_polynomial_.size(); i-- > 1;) {
    sum = sum * theta + static_cast<double>(i) * inverse_polynomial_[i];
  }
  return sum;
}

std::optional<Eigen::Vector2d> Ocam::project(const Eigen::Vector3d& ray) const {
  const auto seen = off_axis(ray, max_angle_rad_);
  if (!seen) return std::nullopt;
  if (seen->across == 0) return centre_px_;
  const double scale = std::max(radius_px(seen->angle_rad), 0.0) / seen->across;
  return Eigen::Vector2d(pixel_from_plane_ * (scale * ray.head<2>()) + centre_px_);
}

std::optional<Eigen::Vector3d> Ocam::unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d plane = plane_from_pixel_ * (pixel - centre_px_);
  const double r = plane.norm();
  if (!(r <= max_radius_px_ * (1 + kAngleSlackRad))) return std::nullopt;
  if (r == 0 || r <= radius_px(0)) return Eigen::Vector3d::UnitZ();
  const double angle =
      monotone_root([this](double t) { return radius_px(t); }, [this](double t) { return radius_slope(t); },
                    std::min(r, max_radius_px_), 0, max_angle_rad_, max_angle_rad_ * r / max_radius_px_);
  const double across = std::sin(angle) / r;
  return Eigen::Vector3d(across * plane.x(), across * plane.y(), std::cos(angle));
}

}  // namespace svchain::geometry
