#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

bool Camera::contains(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.x() <= image_size_px.x() - 0.5 && pixel.y() >= -0.5 &&
         pixel.y() <= image_size_px.y() - 0.5;
}

std::optional<Eigen::Vector2d> Camera::see(const Eigen::Vector3d& point_in_vehicle) const {
  const Eigen::Vector3d ray =
      vehicle_from_camera.rotation.conjugate() * (point_in_vehicle - vehicle_from_camera.translation);
  const auto pixel = lens->project(ray);
  if (!pixel || !contains(*pixel)) return std::nullopt;
  return pixel;
}

}  // namespace svchain::geometry
