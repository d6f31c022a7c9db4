#include "algorithms/geometry/refine_pose.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace svchain::geometry {

namespace {

using Step = Eigen::Matrix<double, 6, 1>;  // rotation (rad) about the vehicle's axes, translation (m)

constexpr double kLostPx = 100;  // residual of a point that the lens cannot see from a pose

Rigid3 moved(const Rigid3& pose, const Step& step) {
  const Eigen::Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  const Eigen::Quaterniond turned =
      angle > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) : Eigen::Quaterniond::Identity();
  return {(turned * pose.rotation).normalized(), pose.translation + step.tail<3>()};
}

Eigen::VectorXd residuals(const Lens& lens, const std::vector<Sighting>& sightings, const Rigid3& pose) {
  const Rigid3 camera_from_vehicle = pose.inverse();
  Eigen::VectorXd r(2 * static_cast<Eigen::Index>(sightings.size()));
  Eigen::Index row = 0;
  for (const auto& sighting : sightings) {
    const auto pixel = lens.project(camera_from_vehicle * sighting.point_in_vehicle);
    r.segment<2>(row) = pixel ? Eigen::Vector2d(*pixel - sighting.pixel) : Eigen::Vector2d::Constant(kLostPx);
    row += 2;
  }
  return r;
}

Eigen::MatrixXd jacobian(const Lens& lens, const std::vector<Sighting>& sightings, const Rigid3& pose) {
  constexpr double kDelta = 1e-6;
  Eigen::MatrixXd j(2 * static_cast<Eigen::Index>(sightings.size()), 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Step step = kDelta * Step::Unit(i);
    j.col(i) =
        (residuals(lens, sightings, moved(pose, step)) - residuals(lens, sightings, moved(pose, -step))) /
        (2 * kDelta);
  }
  return j;
}

}  // namespace

RefinedPose refine_pose(const Lens& lens, const std::vector<Sighting>& sightings, const Rigid3& start) {
  constexpr int kMostRounds = 100;
  constexpr double kEnough = 1e-12;  // of the cost, in one round
  Rigid3 pose = start;
  Eigen::VectorXd r = residuals(lens, sightings, pose);
  double damping = 1e-3;
  for (int round = 0; round < kMostRounds && damping < 1e12; ++round) {
    const Eigen::MatrixXd j = jacobian(lens, sightings, pose);
    const Eigen::Matrix<double, 6, 6> normal = j.transpose() * j;
    const Step gradient = j.transpose() * r;
    bool better = false;
    double gain = 0;
    for (; !better && damping < 1e12; damping *= better ? 0.1 : 10) {
      Eigen::Matrix<double, 6, 6> damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + 1e-12).matrix();
      const Rigid3 tried = moved(pose, -damped.ldlt().solve(gradient));
      const Eigen::VectorXd tried_r = residuals(lens, sightings, tried);
      gain = r.squaredNorm() - tried_r.squaredNorm();
      better = gain > 0;  // false for NaN too
      if (!better) continue;
      pose = tried;
      r = tried_r;
    }
    if (gain <= kEnough * r.squaredNorm()) break;
  }
  return {pose, std::sqrt(r.squaredNorm() / static_cast<double>(sightings.size()))};
}

}  // namespace svchain::geometry
