#pragma once
// Where every projection begins: how far a ray is off the optical axis, and whether the lens serves there.
// Pure, allocates nothing.

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "algorithms/geometry/angles.h"

namespace svchain::geometry {

struct OffAxis {
  double across;     // length of the ray's (x, y); 0 on the axis, where the picture's centre is
  double angle_rad;  // from the axis
};

/// Nothing for a zero ray, one that is no number, or one beyond the largest angle.
inline std::optional<OffAxis> off_axis(const Eigen::Vector3d& ray, double max_angle_rad) {
  const double across = std::hypot(ray.x(), ray.y());
  if (across == 0 && !(ray.z() > 0)) return std::nullopt;
  const double angle = std::atan2(across, ray.z());
  if (!(angle <= max_angle_rad + kAngleSlackRad)) return std::nullopt;  // also refuses NaN
  return OffAxis{across, angle};
}

}  // namespace svchain::geometry
