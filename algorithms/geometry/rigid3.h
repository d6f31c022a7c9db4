#pragma once
// A rigid motion in space, named for what it maps: `vehicle_from_camera` takes points in the camera's frame
// to the vehicle's. Metres. Plain value.

#include <Eigen/Geometry>

namespace svchain::geometry {

struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation; }
  Rigid3 operator*(const Rigid3& other) const {
    return {rotation * other.rotation, rotation * other.translation + translation};
  }
  Rigid3 inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
  }
};

/// The pose turned by a rotation vector (rad) about its target frame's axes, its own origin staying where it
/// is, then shifted in that frame.
inline Rigid3 turned_and_shifted(const Rigid3& pose, const Eigen::Vector3d& turn_rad,
                                 const Eigen::Vector3d& shift_m) {
  const double angle = turn_rad.norm();
  const Eigen::Quaterniond turn = angle > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn_rad / angle))
                                            : Eigen::Quaterniond::Identity();
  return {(turn * pose.rotation).normalized(), pose.translation + shift_m};
}

}  // namespace svchain::geometry
