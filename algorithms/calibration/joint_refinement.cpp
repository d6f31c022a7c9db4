#include "algorithms/calibration/joint_refinement.h"

#include <Eigen/Cholesky>

#include "algorithms/calibration/joint_model.h"
#include "algorithms/geometry/levenberg_marquardt.h"

namespace svchain::calibration {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;

MatrixXd inverse(const MatrixXd& normal) {
  return normal.ldlt().solve(MatrixXd::Identity(normal.rows(), normal.cols()));
}

}  // namespace

std::optional<Vector2d> residual_px(const CornerSighting& sighting, const UnknownCamera& camera,
                                    const UnknownChart& chart) {
  const Vector2d ground = chart.vehicle_from_chart * sighting.place_m;
  const auto& pose = camera.vehicle_from_camera;
  const auto pixel = camera.lens->project(pose.rotation.conjugate() *
                                          (Eigen::Vector3d(ground.x(), ground.y(), 0) - pose.translation));
  if (!pixel) return std::nullopt;
  return *pixel - sighting.pixel;
}

JointSolution refine_jointly(const JointProblem& problem) {
  constexpr double kEnough = 1e-5;  // of a sum that is about the number of residuals
  const JointModel model(problem);
  JointModel::State state =
      geometry::least_squares(model, JointModel::State{problem.cameras, problem.charts}, kEnough);
  const MatrixXd j = model.jacobian(state);
  const MatrixXd normal = j.transpose() * j;
  const MatrixXd covariance = inverse(normal);
  const MatrixXd relative = inverse(normal + model.held_in_place(state));
  JointSolution solution{std::move(state.cameras), std::move(state.charts), {}, {}};
  for (size_t c = 0; c < solution.cameras.size(); ++c) {
    solution.covariance.push_back(model.camera_block(covariance, c));
    solution.relative_covariance.push_back(model.camera_block(relative, c));
  }
  return solution;
}

}  // namespace svchain::calibration
