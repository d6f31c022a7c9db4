#include "algorithms/calibration/joint_refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "algorithms/calibration/lens_prior.h"
#include "algorithms/geometry/lens_parameters.h"
#include "algorithms/geometry/levenberg_marquardt.h"

namespace svchain::calibration {

namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using geometry::Lens;

constexpr double kLostPx = 100;  // residual of a corner that the lens cannot see
constexpr Index kPoseUnknowns = 6;
constexpr Index kChartUnknowns = 3;

struct State {
  std::vector<UnknownCamera> cameras;
  std::vector<UnknownChart> charts;
};

Vector3d point_of(const CornerSighting& sighting, const UnknownChart& chart) {
  const Vector2d ground = chart.vehicle_from_chart * sighting.place_m;
  return {ground.x(), ground.y(), 0};
}

/// The symmetric root of the inverse: whitens residuals of this covariance.
Matrix2d whitening(const Matrix2d& covariance) {
  return covariance.llt().matrixL().solve(Matrix2d::Identity());
}

/// d pixel / d ray, by central differences.
Eigen::Matrix<double, 2, 3> ray_jacobian(const Lens& lens, const Vector3d& ray) {
  const double delta = 1e-6 * ray.norm();
  Eigen::Matrix<double, 2, 3> j = Eigen::Matrix<double, 2, 3>::Zero();
  for (Index i = 0; i < 3; ++i) {
    const auto after = lens.project(ray + delta * Vector3d::Unit(i));
    const auto before = lens.project(ray - delta * Vector3d::Unit(i));
    if (after && before) j.col(i) = (*after - *before) / (2 * delta);
  }
  return j;
}

Eigen::Matrix3d cross(const Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// A lens with each of its parameters a little larger and a little smaller.
struct NearbyLenses {
  std::vector<geometry::LensPtr> after, before;
  std::vector<double> step;
};

class JointModel {
 public:
  explicit JointModel(const JointProblem& problem) : problem_(problem) {
    for (const auto& camera : problem.cameras) {
      camera_at_.push_back(unknowns_);
      unknowns_ += kPoseUnknowns;
      rows_ += camera.pose_prior ? kPoseUnknowns : 0;
      lens_priors_.emplace_back();
      if (!camera.lens_prior) continue;
      lens_priors_.back().emplace(camera.lens_prior->lens, camera.lens_prior->sigma_px);
      unknowns_ += lens_priors_.back()->parameters();
      rows_ += lens_priors_.back()->rows();
    }
    for (const auto& chart : problem.charts) {
      chart_at_.push_back(unknowns_);
      if (!chart.fixed) unknowns_ += kChartUnknowns;
    }
    for (const auto& sighting : problem.sightings) whitening_.push_back(whitening(sighting.covariance_px2));
    rows_ += 2 * static_cast<Index>(problem.sightings.size());
  }

  VectorXd residuals(const State& state) const {
    VectorXd r(rows_);
    Index row = 0;
    for (size_t s = 0; s < whitening_.size(); ++s, row += 2) {
      const CornerSighting& sighting = problem_.sightings[s];
      const auto off = residual_px(sighting, state.cameras[sighting.camera], state.charts[sighting.chart]);
      r.segment<2>(row) = whitening_[s] * off.value_or(Vector2d::Constant(kLostPx));
    }
    for (size_t c = 0; c < state.cameras.size(); ++c) {
      const UnknownCamera& camera = state.cameras[c];
      if (camera.pose_prior) {
        r.segment<kPoseUnknowns>(row) = off_prior(camera);
        row += kPoseUnknowns;
      }
      if (lens_priors_[c]) {
        r.segment(row, lens_priors_[c]->rows()) = lens_priors_[c]->residuals(*camera.lens);
        row += lens_priors_[c]->rows();
      }
    }
    return r;
  }

  MatrixXd jacobian(const State& state) const {
    MatrixXd j = MatrixXd::Zero(rows_, unknowns_);
    std::vector<NearbyLenses> nearby;
    for (size_t c = 0; c < state.cameras.size(); ++c) nearby.push_back(nearby_lenses(c, *state.cameras[c].lens));
    Index row = 0;
    for (size_t s = 0; s < whitening_.size(); ++s, row += 2) add_sighting(state, nearby, s, j.middleRows(row, 2));
    for (size_t c = 0; c < state.cameras.size(); ++c) {
      if (const auto& prior = state.cameras[c].pose_prior) {
        auto block = j.block<kPoseUnknowns, kPoseUnknowns>(row, camera_at_[c]);
        block.diagonal().head<3>().setConstant(1 / prior->sigma_rad);
        block.diagonal().tail<3>().setConstant(1 / prior->sigma_m);
        row += kPoseUnknowns;
      }
      if (!lens_priors_[c]) continue;
      for (size_t p = 0; p < nearby[c].step.size(); ++p) {
        j.block(row, camera_at_[c] + kPoseUnknowns + static_cast<Index>(p), lens_priors_[c]->rows(), 1) =
            (lens_priors_[c]->residuals(*nearby[c].after[p]) - lens_priors_[c]->residuals(*nearby[c].before[p])) /
            (2 * nearby[c].step[p]);
      }
      row += lens_priors_[c]->rows();
    }
    return j;
  }

  State moved(State state, const VectorXd& step) const {
    for (size_t c = 0; c < state.cameras.size(); ++c) {
      UnknownCamera& camera = state.cameras[c];
      const Index at = camera_at_[c];
      camera.vehicle_from_camera = geometry::turned_and_shifted(
          camera.vehicle_from_camera, step.segment<3>(at), step.segment<3>(at + 3));
      if (!lens_priors_[c]) continue;
      std::vector<double> parameters = geometry::lens_parameters(*camera.lens);
      for (size_t p = 0; p < parameters.size(); ++p)
        parameters[p] += step[at + kPoseUnknowns + static_cast<Index>(p)];
      // A step to where no lens is is not taken: the sum is the same, so it counts as no gain.
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

  /// What it adds to the normal matrix to know that cameras do not shift or turn about the vertical on average.
  MatrixXd held_in_place(const State& state) const {
    constexpr double kHeld = 1e12;  // 1 / (1e-6 m or rad)^2
    MatrixXd mean = MatrixXd::Zero(3, unknowns_);
    for (size_t c = 0; c < state.cameras.size(); ++c) {
      const Vector3d& place = state.cameras[c].vehicle_from_camera.translation;
      // A common turn moves a camera across its place, so the turn's mean is told by turn and shift together.
      mean.block<1, 2>(0, camera_at_[c] + 3) << 1, 0;
      mean.block<1, 2>(1, camera_at_[c] + 3) << 0, 1;
      mean.block<1, 2>(2, camera_at_[c] + 3) << -place.y(), place.x();
    }
    return kHeld * mean.transpose() * mean;
  }

  MatrixXd covariance_of(const MatrixXd& covariance, size_t camera) const {
    const Index count = kPoseUnknowns + (lens_priors_[camera] ? lens_priors_[camera]->parameters() : 0);
    return covariance.block(camera_at_[camera], camera_at_[camera], count, count);
  }

 private:
  static Eigen::Matrix<double, kPoseUnknowns, 1> off_prior(const UnknownCamera& camera) {
    const PosePrior& prior = *camera.pose_prior;
    const Eigen::AngleAxisd turn(camera.vehicle_from_camera.rotation *
                                 prior.vehicle_from_camera.rotation.conjugate());
    Eigen::Matrix<double, kPoseUnknowns, 1> off;
    off << turn.axis() * std::remainder(turn.angle(), 2 * M_PI) / prior.sigma_rad,
        (camera.vehicle_from_camera.translation - prior.vehicle_from_camera.translation) / prior.sigma_m;
    return off;
  }

  NearbyLenses nearby_lenses(size_t camera, const Lens& lens) const {
    NearbyLenses made;
    if (!lens_priors_[camera]) return made;
    const std::vector<double> parameters = geometry::lens_parameters(lens);
    for (size_t p = 0; p < parameters.size(); ++p) {
      made.step.push_back(lens_priors_[camera]->step(p));
      for (const int sign : {1, -1}) {
        std::vector<double> changed = parameters;
        changed[p] += sign * made.step[p];
        auto moved_lens = geometry::with_parameters(lens, changed);
        if (!moved_lens) moved_lens = geometry::with_parameters(lens, parameters);
        (sign > 0 ? made.after : made.before).push_back(std::move(moved_lens));
      }
    }
    return made;
  }

  template <class Rows>
  void add_sighting(const State& state, const std::vector<NearbyLenses>& nearby, size_t s, Rows rows) const {
    const CornerSighting& sighting = problem_.sightings[s];
    const UnknownCamera& camera = state.cameras[sighting.camera];
    const UnknownChart& chart = state.charts[sighting.chart];
    const Vector3d point = point_of(sighting, chart);
    const Vector3d from_camera = point - camera.vehicle_from_camera.translation;
    const Eigen::Matrix3d camera_from_vehicle =
        camera.vehicle_from_camera.rotation.conjugate().toRotationMatrix();
    const Vector3d ray = camera_from_vehicle * from_camera;
    if (!camera.lens->project(ray)) return;
    const Eigen::Matrix<double, 2, 3> per_point =
        whitening_[s] * ray_jacobian(*camera.lens, ray) * camera_from_vehicle;
    const Index at = camera_at_[sighting.camera];
    rows.template middleCols<3>(at) = per_point * cross(from_camera);
    rows.template middleCols<3>(at + 3) = -per_point;
    const NearbyLenses& lenses = nearby[sighting.camera];
    for (size_t p = 0; p < lenses.step.size(); ++p) {
      const auto after = lenses.after[p]->project(ray);
      const auto before = lenses.before[p]->project(ray);
      if (after && before)
        rows.col(at + kPoseUnknowns + static_cast<Index>(p)) =
            whitening_[s] * (*after - *before) / (2 * lenses.step[p]);
    }
    if (chart.fixed) return;
    const Vector2d arm = point.head<2>() - Vector2d(chart.vehicle_from_chart.x_m, chart.vehicle_from_chart.y_m);
    rows.template middleCols<2>(chart_at_[sighting.chart]) = per_point.template leftCols<2>();
    rows.col(chart_at_[sighting.chart] + 2) = per_point.template leftCols<2>() * Vector2d(-arm.y(), arm.x());
  }

  const JointProblem& problem_;
  Index unknowns_ = 0;
  Index rows_ = 0;
  std::vector<Index> camera_at_, chart_at_;
  std::vector<std::optional<LensPrior>> lens_priors_;
  std::vector<Matrix2d> whitening_;
};

}  // namespace

std::optional<Vector2d> residual_px(const CornerSighting& sighting, const UnknownCamera& camera,
                                    const UnknownChart& chart) {
  const geometry::Rigid3 camera_from_vehicle = camera.vehicle_from_camera.inverse();
  const auto pixel = camera.lens->project(camera_from_vehicle * point_of(sighting, chart));
  if (!pixel) return std::nullopt;
  return *pixel - sighting.pixel;
}

JointSolution refine_jointly(const JointProblem& problem) {
  const JointModel model(problem);
  State state = geometry::least_squares(model, State{problem.cameras, problem.charts});
  const MatrixXd j = model.jacobian(state);
  const MatrixXd normal = j.transpose() * j;
  const auto inverse = [](const MatrixXd& m) {
    return MatrixXd(m.ldlt().solve(MatrixXd::Identity(m.rows(), m.cols())));
  };
  const MatrixXd covariance = inverse(normal);
  const MatrixXd relative = inverse(normal + model.held_in_place(state));
  JointSolution solution{std::move(state.cameras), std::move(state.charts), {}, {}};
  for (size_t c = 0; c < solution.cameras.size(); ++c) {
    solution.covariance.push_back(model.covariance_of(covariance, c));
    solution.relative_covariance.push_back(model.covariance_of(relative, c));
  }
  return solution;
}

}  // namespace svchain::calibration
