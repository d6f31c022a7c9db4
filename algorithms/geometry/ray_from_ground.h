#pragma once
// The ground as a camera sees it: the perspective matrix that takes (x, y, 1) on the ground, metres, to a ray
// in the camera's frame, [r1 r2 t] of the pose (Hartley and Zisserman, "Multiple View Geometry", 8.1). Pure.

#include <Eigen/Core>

#include "algorithms/geometry/rigid3.h"

namespace svchain::geometry {

inline Eigen::Matrix3d ray_from_ground(const Rigid3& vehicle_from_camera) {
  const Rigid3 camera_from_vehicle = vehicle_from_camera.inverse();
  Eigen::Matrix3d matrix = camera_from_vehicle.rotation.toRotationMatrix();
  matrix.col(2) = camera_from_vehicle.translation;
  return matrix;
}

}  // namespace svchain::geometry
