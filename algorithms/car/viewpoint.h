#pragma once
// From where the car is seen: a pinhole camera in the vehicle's frame. Camera axes x right, y down, z along
// the optical axis; pixel (0,0) is the centre of the first pixel. Plain value.

#include <Eigen/Core>

#include "algorithms/bowl/viewpoint.h"

namespace svchain::car {

struct Viewpoint {
  Eigen::Matrix3d camera_from_vehicle = Eigen::Matrix3d::Identity();  // a rotation
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();                      // in the vehicle's frame, metres
  double focal_px = 1000;
  Eigen::Vector2d centre_px = {0, 0};
  Eigen::Vector2i size_px = {0, 0};

  bool operator==(const Viewpoint& other) const {
    return camera_from_vehicle == other.camera_from_vehicle && eye == other.eye &&
           focal_px == other.focal_px && centre_px == other.centre_px && size_px == other.size_px;
  }
  /// In the camera's frame.
  Eigen::Vector3d seen(const Eigen::Vector3d& point) const { return camera_from_vehicle * (point - eye); }
  /// Of a point in the camera's frame before the camera.
  Eigen::Vector2d pixel(const Eigen::Vector3d& seen) const {
    return centre_px + focal_px / seen.z() * seen.head<2>();
  }
};

/// As the bowl around the car is shown. `viewpoint` is free of faults.
Viewpoint seen_from(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px);

}  // namespace svchain::car
