#pragma once
// The perspective matrices that rigs have, and rigs that are a little off.

#include <random>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/ray_from_ground.h"
#include "algorithms/registration/alignment.h"
#include "algorithms/registration/disagreement.h"

namespace svchain::testing {

inline Eigen::Matrix3d perspective_of(const geometry::Camera& camera) {
  return geometry::ray_from_ground(camera.vehicle_from_camera);
}

inline registration::Perspectives perspectives_of(const geometry::Rig& rig) {
  registration::Perspectives matrices;
  for (size_t i = 0; i < 4; ++i) matrices[i] = perspective_of(rig.cameras[i]);
  return matrices;
}

inline registration::Steps no_steps() {
  registration::Steps steps;
  for (auto& step : steps) step.setZero();
  return steps;
}

/// Every camera moved and turned by at most so much about each axis.
inline geometry::Rig disturbed(geometry::Rig rig, double position_m, double rotation_deg, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> within(-1, 1);
  const auto error = [&] { return Eigen::Vector3d(within(random), within(random), within(random)); };
  for (auto& camera : rig.cameras) {
    geometry::Rigid3& pose = camera.vehicle_from_camera;
    const Eigen::Vector3d turn = geometry::radians(rotation_deg) * error();
    pose.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.rotation;
    pose.translation += position_m * error();
  }
  return rig;
}

/// The task of aligning frames from where a rig says its cameras are.
inline registration::AlignmentTask task_of(const geometry::Rig& rig, const std::array<cv::Mat, 4>& frames,
                                           double position_m, double rotation_deg) {
  constexpr double kEvenToSigma = 0.58;
  registration::AlignmentTask task;
  task.frames = frames;
  task.vehicle = rig.vehicle;
  task.start = {kEvenToSigma * geometry::radians(rotation_deg), kEvenToSigma * position_m, 0.01};
  for (size_t i = 0; i < 4; ++i) {
    const geometry::Camera& camera = rig.cameras[i];
    task.cameras[i] = {camera.lens, camera.image_size_px, perspective_of(camera)};
  }
  return task;
}

}  // namespace svchain::testing
