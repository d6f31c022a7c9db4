#include "algorithms/calibration/joint_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace svchain::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLostPx = 100;  // residual of a corner that the lens cannot see
constexpr Index kPoseUnknowns = 6;
constexpr Index kChartUnknowns = 3;

Vector3d point_of(const CornerSighting& sighting, const UnknownChart& chart) {
  const Vector2d ground = chart.vehicle_from_chart * sighting.place_m;
  return {ground.x(), ground.y(), 0};
}

/// cross_matrix(v) * w = v x w.
Eigen::Matrix3d cross_matrix(const Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Eigen::Matrix<double, kPoseUnknowns, 1> off_prior(const UnknownCamera& camera) {
  const PosePrior& prior = *camera.pose_prior;
  const Eigen::AngleAxisd turn(camera.vehicle_from_camera.rotation *
                               prior.vehicle_from_camera.rotation.conjugate());
  Eigen::Matrix<double, kPoseUnknowns, 1> off;
  off << turn.axis() * std::remainder(turn.angle(), 2 * M_PI) / prior.sigma_rad,
      (camera.vehicle_from_camera.translation - prior.vehicle_from_camera.translation) / prior.sigma_m;
  return off;
}

}  // namespace

JointModel::JointModel(const JointProblem& problem) : problem_(problem) {
  for (const auto& camera : problem_.cameras) {
    camera_at_.push_back(unknowns_);
    lens_priors_.emplace_back();
    if (camera.lens_prior) lens_priors_.back().emplace(*camera.lens_prior->lens, camera.lens_prior->sigma_px);
    unknowns_ += kPoseUnknowns + lens_unknowns(camera_at_.size() - 1);
    rows_ +=
        (camera.pose_prior ? kPoseUnknowns : 0) + (lens_priors_.back() ? lens_priors_.back()->rows() : 0);
  }
  for (const auto& chart : problem_.charts) {
    chart_at_.push_back(unknowns_);
    if (!chart.fixed) unknowns_ += kChartUnknowns;
  }
  for (const auto& sighting : problem_.sightings)
    whitening_.push_back(sighting.covariance_px2.llt().matrixL().solve(Eigen::Matrix2d::Identity()));
  rows_ += 2 * static_cast<Index>(whitening_.size());
}

Index JointModel::lens_unknowns(size_t camera) const {
  if (!problem_.cameras[camera].lens_prior) return 0;
  return static_cast<Index>(geometry::lens_parameters(*problem_.cameras[camera].lens).size());
}

VectorXd JointModel::residuals(const State& state) const {
  VectorXd r(rows_);
  Index row = 0;
  for (size_t s = 0; s < whitening_.size(); ++s, row += 2) {
    const CornerSighting& sighting = problem_.sightings[s];
    const auto off = residual_px(sighting, state.cameras[sighting.camera], state.charts[sighting.chart]);
    r.segment<2>(row) = whitening_[s] * off.value_or(Vector2d::Constant(kLostPx));
  }
  for (size_t c = 0; c < state.cameras.size(); ++c) {
    if (state.cameras[c].pose_prior) {
      r.segment<kPoseUnknowns>(row) = off_prior(state.cameras[c]);
      row += kPoseUnknowns;
    }
    if (const auto& prior = lens_priors_[c]) {
      r.segment(row, prior->rows()) = prior->residuals(*state.cameras[c].lens);
      row += prior->rows();
    }
  }
  return r;
}

MatrixXd JointModel::jacobian(const State& state) const {
  MatrixXd j = MatrixXd::Zero(rows_, unknowns_);
  FreeLenses lenses;
  for (const auto& camera : state.cameras) {
    lenses.emplace_back();
    if (camera.lens_prior) lenses.back().emplace(*camera.lens);
  }
  Index row = 0;
  for (size_t s = 0; s < whitening_.size(); ++s, row += 2) {
    auto rows = j.middleRows<2>(row);
    add_sighting(state, lenses, problem_.sightings[s], rows);
    rows = whitening_[s] * rows.eval();
  }
  for (size_t c = 0; c < state.cameras.size(); ++c) {
    if (const auto& prior = state.cameras[c].pose_prior) {
      auto block = j.block<kPoseUnknowns, kPoseUnknowns>(row, camera_at_[c]);
      block.diagonal().head<3>().setConstant(1 / prior->sigma_rad);
      block.diagonal().tail<3>().setConstant(1 / prior->sigma_m);
      row += kPoseUnknowns;
    }
    if (const auto& prior = lens_priors_[c]) {
      j.block(row, camera_at_[c] + kPoseUnknowns, prior->rows(), lens_unknowns(c)) =
          prior->jacobian(*lenses[c], lens_unknowns(c));
      row += prior->rows();
    }
  }
  return j;
}

/// With v from the camera to the point and R its rotation, the ray is R' v: a turn w of the camera about the
/// vehicle's axes changes it by R' (v x w), a shift t by -R' t.
void JointModel::add_sighting(const State& state, const FreeLenses& lenses, const CornerSighting& sighting,
                              Eigen::Ref<MatrixXd> rows) const {
  const UnknownCamera& camera = state.cameras[sighting.camera];
  const UnknownChart& chart = state.charts[sighting.chart];
  const Vector3d point = point_of(sighting, chart);
  const Vector3d from_camera = point - camera.vehicle_from_camera.translation;
  const Eigen::Matrix3d camera_from_vehicle =
      camera.vehicle_from_camera.rotation.conjugate().toRotationMatrix();
  const Vector3d ray = camera_from_vehicle * from_camera;
  const auto pixel = geometry::project_with_jacobian(*camera.lens, ray);
  if (!pixel) return;
  const Eigen::Matrix<double, 2, 3> by_point = pixel->by_ray * camera_from_vehicle;
  const Index at = camera_at_[sighting.camera];
  rows.middleCols<3>(at) = by_point * cross_matrix(from_camera);
  rows.middleCols<3>(at + 3) = -by_point;
  if (lenses[sighting.camera]) {
    if (const auto by_lens = lenses[sighting.camera]->by_parameters(ray))
      rows.middleCols(at + kPoseUnknowns, by_lens->cols()) = *by_lens;
  }
  if (chart.fixed) return;
  const Vector2d arm = point.head<2>() - Vector2d(chart.vehicle_from_chart.x_m, chart.vehicle_from_chart.y_m);
  rows.middleCols<2>(chart_at_[sighting.chart]) = by_point.leftCols<2>();
  rows.col(chart_at_[sighting.chart] + 2) = by_point.leftCols<2>() * Vector2d(-arm.y(), arm.x());
}

JointModel::State JointModel::moved(State state, const VectorXd& step) const {
  for (size_t c = 0; c < state.cameras.size(); ++c) {
    UnknownCamera& camera = state.cameras[c];
    const Index at = camera_at_[c];
    camera.vehicle_from_camera = geometry::turned_and_shifted(camera.vehicle_from_camera, step.segment<3>(at),
                                                              step.segment<3>(at + 3));
    if (!camera.lens_prior) continue;
    std::vector<double> parameters = geometry::lens_parameters(*camera.lens);
    for (size_t p = 0; p < parameters.size(); ++p)
      parameters[p] += step[at + kPoseUnknowns + static_cast<Index>(p)];
    // A step to where there is no lens leaves it as it is.
    if (auto lens = geometry::with_parameters(*camera.lens, parameters)) camera.lens = std::move(lens);
  }
  for (size_t k = 0; k < state.charts.size(); ++k) {
    if (state.charts[k].fixed) continue;
    geometry::Pose2& pose = state.charts[k].vehicle_from_chart;
    pose.x_m += step[chart_at_[k]];
    pose.y_m += step[chart_at_[k] + 1];
    pose.yaw_rad += step[chart_at_[k] + 2];
  }
  return state;
}

MatrixXd JointModel::held_in_place(const State& state) const {
  constexpr double kHeld = 1e12;  // 1 / (1e-6 m)^2
  MatrixXd mean = MatrixXd::Zero(3, unknowns_);
  for (size_t c = 0; c < state.cameras.size(); ++c) {
    const Vector3d& place = state.cameras[c].vehicle_from_camera.translation;
    // A common turn shifts every camera across its place.
    mean.block<3, 2>(0, camera_at_[c] + 3) << 1, 0, 0, 1, -place.y(), place.x();
  }
  return kHeld * mean.transpose() * mean;
}

MatrixXd JointModel::camera_block(const MatrixXd& matrix, size_t camera) const {
  const Index count = kPoseUnknowns + lens_unknowns(camera);
  return matrix.block(camera_at_[camera], camera_at_[camera], count, count);
}

}  // namespace svchain::calibration
