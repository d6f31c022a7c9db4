#include "algorithms/synthesis/camera_reach.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/own_body.h"
#include "algorithms/synthesis/smoothstep.h"

namespace svchain::synthesis {

CameraReach::CameraReach(const geometry::Camera& camera, const RayFromPoint& ray_from_point,
                         const geometry::Vehicle& vehicle)
    : lens_(camera.lens),
      ray_from_point_(ray_from_point),
      vehicle_(vehicle),
      position_(camera.vehicle_from_camera.translation.head<2>()) {
  last_pixel_ = (camera.image_size_px.array() - 1).matrix().cast<double>();
  border_px_ = kBorder * camera.image_size_px.minCoeff();
  cos_lens_border_ = std::cos(std::max(0.0, lens_->max_angle_rad() - kLensBorderRad));
}

std::optional<CameraReach::Seen> CameraReach::see(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d ray = ray_from_point_.leftCols<3>() * point + ray_from_point_.col(3);
  const auto pixel = lens_->project(ray);
  if (!pixel) return std::nullopt;
  const double inside = std::min(pixel->minCoeff(), (last_pixel_ - *pixel).minCoeff());
  if (!(inside >= 0)) return std::nullopt;

  double fade = smoothstep(inside / border_px_) * sight_past_body(vehicle_, position_, point.head<2>());
  if (ray.z() < cos_lens_border_ * ray.norm()) {  // the angle itself is dear and seldom needed
    const double angle = std::atan2(ray.head<2>().norm(), ray.z());
    fade *= smoothstep((lens_->max_angle_rad() - angle) / kLensBorderRad);
  }
  return Seen{*pixel, fade};
}

}  // namespace svchain::synthesis
