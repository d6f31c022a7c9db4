#pragma once
// A camera's pose set right by what it sees: a chart is flat and its squares are of one size, so even one
// whose place nobody knows tells the camera's height and tilt. What then is left of a rough pose's error is a
// turn about the vertical and a shift, and corners can be told apart by where they are. Pure.

#include "algorithms/calibration/fragments.h"
#include "algorithms/calibration/joint_refinement.h"

namespace svchain::calibration {

struct Levelled {
  geometry::Rigid3 vehicle_from_camera;
  std::vector<Fragment> fragments;                     // those that lie on the ground
  std::vector<geometry::Pose2> vehicle_from_fragment;  // of each
};

/// `prior` is about the camera's pose.
Levelled level_camera(const geometry::Camera& camera, const PosePrior& prior,
                      std::vector<Fragment> fragments);

/// Where a pixel's ray meets the ground; nothing where it does not.
std::optional<Eigen::Vector2d> ground_of(const geometry::Lens& lens,
                                         const geometry::Rigid3& vehicle_from_camera,
                                         const Eigen::Vector2d& pixel);

/// The turn and shift that take places next to other places, in the least squares sense (Umeyama 1991).
geometry::Pose2 pose_between(const std::vector<Eigen::Vector2d>& from,
                             const std::vector<Eigen::Vector2d>& to);

}  // namespace svchain::calibration
