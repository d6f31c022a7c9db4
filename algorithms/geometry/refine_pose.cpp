#include "algorithms/geometry/refine_pose.h"

#include <cmath>

#include "algorithms/geometry/levenberg_marquardt.h"

namespace svchain::geometry {

namespace {

constexpr double kEnough = 1e-12;
constexpr double kLostPx = 100;  // residual of a point that the lens cannot see from a pose

/// The six numbers of one camera's pose.
struct PoseModel {
  const Lens& lens;
  const std::vector<Sighting>& sightings;

  Eigen::VectorXd residuals(const Rigid3& pose) const {
    const Rigid3 camera_from_vehicle = pose.inverse();
    Eigen::VectorXd r(2 * static_cast<Eigen::Index>(sightings.size()));
    Eigen::Index row = 0;
    for (const auto& sighting : sightings) {
      const auto pixel = lens.project(camera_from_vehicle * sighting.point_in_vehicle);
      r.segment<2>(row) =
          pixel ? Eigen::Vector2d(*pixel - sighting.pixel) : Eigen::Vector2d::Constant(kLostPx);
      row += 2;
    }
    return r;
  }

  Eigen::MatrixXd jacobian(const Rigid3& pose) const {
    constexpr double kDelta = 1e-6;
    Eigen::MatrixXd j(2 * static_cast<Eigen::Index>(sightings.size()), 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
      const Eigen::VectorXd step = kDelta * Eigen::VectorXd::Unit(6, i);
      j.col(i) = (residuals(moved(pose, step)) - residuals(moved(pose, -step))) / (2 * kDelta);
    }
    return j;
  }

  /// A step turns about the vehicle's axes (rad), then shifts (m).
  Rigid3 moved(const Rigid3& pose, const Eigen::VectorXd& step) const {
    return turned_and_shifted(pose, step.head<3>(), step.tail<3>());
  }
};

}  // namespace

RefinedPose refine_pose(const Lens& lens, const std::vector<Sighting>& sightings, const Rigid3& start) {
  const PoseModel model{lens, sightings};
  const Rigid3 pose = least_squares(model, start, kEnough);
  return {pose, std::sqrt(model.residuals(pose).squaredNorm() / static_cast<double>(sightings.size()))};
}

}  // namespace svchain::geometry
