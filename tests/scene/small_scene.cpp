#include "tests/scene/small_scene.h"

#include <numbers>

#include "algorithms/geometry/kannala_brandt.h"

namespace svchain::testing {

namespace {

/// Looking towards `yaw` from the vehicle's x, tilted down.
geometry::Rigid3 looking(double yaw_rad, double down_rad, const Eigen::Vector3d& from) {
  Eigen::Matrix3d axes;  // the camera's x, y, z in the vehicle's frame
  axes.col(2) = Eigen::Vector3d(std::cos(yaw_rad) * std::cos(down_rad),
                                std::sin(yaw_rad) * std::cos(down_rad), -std::sin(down_rad));
  axes.col(0) = Eigen::Vector3d(std::sin(yaw_rad), -std::cos(yaw_rad), 0);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {Eigen::Quaterniond(axes), from};
}

}  // namespace

scene::Scene small_scene(int width_px) {
  const int height_px = width_px * 9 / 16;
  const double focal_px = width_px * 0.26;
  scene::Scene scene;
  scene.rig.vehicle = {4.8, 1.9};
  const Eigen::Vector3d places[4] = {{2.4, 0, 0.7}, {0.6, -1.0, 1.0}, {-2.4, 0, 0.9}, {0.6, 1.0, 1.0}};
  for (size_t i = 0; i < 4; ++i) {
    geometry::Camera camera;
    camera.name = geometry::kCameraNames[i];
    camera.image_size_px = {width_px, height_px};
    camera.lens = std::make_shared<geometry::KannalaBrandt>(
        Eigen::Vector2d(focal_px, focal_px), Eigen::Vector2d(width_px / 2.0 - 0.5, height_px / 2.0 - 0.5),
        std::array<double, 4>{0, 0, 0, 0});
    camera.vehicle_from_camera = looking(-std::numbers::pi / 2 * static_cast<double>(i), 0.6, places[i]);
    scene.rig.cameras.push_back(camera);
  }
  scene.ground.colour = {100, 100, 100};
  scene.ground.grain_contrast = 0;
  scene.ground.blotch_contrast = 0;
  scene.ground.metres_per_texel = 0.01;
  scene.ground.half_extent_m = 4.8;
  return scene;
}

}  // namespace svchain::testing
