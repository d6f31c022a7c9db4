#pragma once
// A place and heading on the ground: `world_from_vehicle` takes points of the vehicle's ground plane to the
// world's. Metres, radians counter-clockwise seen from above. Plain value.

#include <Eigen/Core>
#include <cmath>

namespace svchain::geometry {

struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;

  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    const double c = std::cos(yaw_rad);
    const double s = std::sin(yaw_rad);
    return {c * point.x() - s * point.y() + x_m, s * point.x() + c * point.y() + y_m};
  }
};

}  // namespace svchain::geometry
