#pragma once

#include <Eigen/Geometry>

#include "algorithms/car/viewpoint.h"

namespace svchain::car {

/// Upright, `target` in the picture's middle. Looking straight down, the vehicle's front is up.
inline Viewpoint look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, double focal_px,
                         const Eigen::Vector2i& size_px) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
  if (right.norm() < 1e-6) right = forward.cross(Eigen::Vector3d::UnitX());
  right.normalize();
  Viewpoint viewpoint;
  viewpoint.camera_from_vehicle << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  viewpoint.eye = eye;
  viewpoint.focal_px = focal_px;
  viewpoint.centre_px = (size_px.cast<double>().array() - 1) / 2;
  viewpoint.size_px = size_px;
  return viewpoint;
}

}  // namespace svchain::car
