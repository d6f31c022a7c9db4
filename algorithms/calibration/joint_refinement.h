#pragma once
// All that a calibration does not know, refined at once: the poses of cameras, the places of charts that
// nobody measured, and lenses. Least squares over the distances in px between where corners are seen and
// where they should be, the lens inside the residual, each weighed by its own uncertainty; with priors on
// what the pictures alone leave open. Plain values; pure.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "algorithms/geometry/pose2.h"
#include "algorithms/geometry/rig.h"

namespace svchain::calibration {

/// How well a pose is known beforehand, per axis of the vehicle.
struct PosePrior {
  geometry::Rigid3 vehicle_from_camera;
  double sigma_rad = 0;
  double sigma_m = 0;
};

/// How well a lens is known beforehand: RMS over its field, px.
struct LensKnowledge {
  geometry::LensPtr lens;
  double sigma_px = 0;
};

struct UnknownCamera {
  geometry::Rigid3 vehicle_from_camera;
  geometry::LensPtr lens;
  std::optional<PosePrior> pose_prior;
  std::optional<LensKnowledge> lens_prior;  // missing: the lens is kept
};

struct UnknownChart {
  geometry::Pose2 vehicle_from_chart;
  bool fixed = true;
};

struct CornerSighting {
  size_t camera = 0;
  size_t chart = 0;
  Eigen::Vector2d place_m = {0, 0};  // in the chart's frame
  Eigen::Vector2d pixel = {0, 0};
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Identity();
};

struct JointProblem {
  std::vector<UnknownCamera> cameras;
  std::vector<UnknownChart> charts;
  std::vector<CornerSighting> sightings;
};

struct JointSolution {
  std::vector<UnknownCamera> cameras;
  std::vector<UnknownChart> charts;
  /// Of each camera: turn about the vehicle's axes (rad), then place (m), then the lens's parameters; what
  /// the sightings' covariances and the priors make of it.
  std::vector<Eigen::MatrixXd> covariance;
  /// The same with cameras and charts as one rigid thing, which only priors hold in its place, standing still
  /// on average: less than `covariance` where no chart has a place.
  std::vector<Eigen::MatrixXd> relative_covariance;
};

/// Where the sighting's corner should be minus where it was seen, px; nothing where the lens does not reach.
std::optional<Eigen::Vector2d> residual_px(const CornerSighting& sighting, const UnknownCamera& camera,
                                           const UnknownChart& chart);

/// The minimum next to the start.
JointSolution refine_jointly(const JointProblem& problem);

}  // namespace svchain::calibration
