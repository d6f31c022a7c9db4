#include "algorithms/geometry/table_lens.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/off_axis.h"

namespace svchain::geometry {

namespace {

constexpr double kMmPerUm = 1e-3;

}  // namespace

TableLens::TableLens(LensTable table, double pixel_um, Eigen::Vector2d centre_px, double max_angle_rad)
    : table_(std::move(table)),
      pixel_um_(pixel_um),
      centre_px_(centre_px),
      height_mm_(lens_curve(table_)),
      max_angle_rad_(std::min(max_angle_rad, height_mm_.last_x())),
      max_radius_px_(height_mm_.at(max_angle_rad_) / (pixel_um_ * kMmPerUm)) {}

std::optional<Eigen::Vector2d> TableLens::project(const Eigen::Vector3d& ray) const {
  const auto seen = off_axis(ray, max_angle_rad_);
  if (!seen) return std::nullopt;
  if (seen->across == 0) return centre_px_;
  const double scale = height_mm_.at(seen->angle_rad) / (pixel_um_ * kMmPerUm) / seen->across;
  return Eigen::Vector2d(centre_px_ + scale * ray.head<2>());
}

std::optional<Eigen::Vector3d> TableLens::unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d offset = pixel - centre_px_;
  const double r = offset.norm();
  if (!(r <= max_radius_px_ * (1 + kAngleSlackRad))) return std::nullopt;
  if (r == 0) return Eigen::Vector3d::UnitZ();
  const double angle = std::min(height_mm_.inverse(r * pixel_um_ * kMmPerUm), max_angle_rad_);
  const double across = std::sin(angle) / r;
  return Eigen::Vector3d(across * offset.x(), across * offset.y(), std::cos(angle));
}

}  // namespace svchain::geometry
