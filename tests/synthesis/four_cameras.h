#pragma once
// A car with four fisheye cameras, for tests.

#include <cmath>
#include <memory>

#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"

namespace svchain::testing {

/// Yaw from straight ahead to the left, pitch downwards.
inline geometry::Camera make_camera(const std::string& name, Eigen::Vector2i size_px,
                                    Eigen::Vector3d position, double yaw_deg, double down_deg) {
  const double yaw = yaw_deg * M_PI / 180, down = down_deg * M_PI / 180;
  Eigen::Matrix3d axes;  // columns: the camera's x, y, z in the vehicle's frame
  axes.col(2) =
      Eigen::Vector3d(std::cos(down) * std::cos(yaw), std::cos(down) * std::sin(yaw), -std::sin(down));
  axes.col(0) = Eigen::Vector3d(std::sin(yaw), -std::cos(yaw), 0);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const double focal = 0.26 * size_px.x();
  const Eigen::Vector2d centre = (size_px.cast<double>().array() - 1) / 2;
  auto lens = std::make_shared<geometry::KannalaBrandt>(Eigen::Vector2d(focal, focal), centre,
                                                        std::array<double, 4>{-0.01, 0.002, -0.0005, 0});
  return {name, size_px, lens, {Eigen::Quaterniond(axes), position}};
}

inline geometry::Rig four_cameras(Eigen::Vector2i size_px = {1280, 720}, double scale = 1) {
  const Eigen::Vector3d front(2.35, 0, 0.7), right(0.6, -1.0, 1.0), rear(-2.35, 0, 0.85), left(0.6, 1.0, 1.0);
  return {{4.8 * scale, 1.9 * scale},
          {make_camera("front", size_px, scale * front, 0, 25),
           make_camera("right", size_px, scale * right, -90, 45),
           make_camera("rear", size_px, scale * rear, 180, 30),
           make_camera("left", size_px, scale * left, 90, 45)}};
}

inline geometry::View view_of(const geometry::Rig& rig, Eigen::Vector2i size_px) {
  return {size_px, geometry::default_metres_per_px(rig.vehicle, size_px), {0, 0}};
}

}  // namespace svchain::testing
