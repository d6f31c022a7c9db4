#include "algorithms/calibration/corner_search.h"

#include <algorithm>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/camera_pose.h"
#include "algorithms/calibration/chart_assignment.h"
#include "algorithms/geometry/angles.h"

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using geometry::Rigid3;

constexpr double kChartReach =
    20;  // times the poses' uncertainty: how far a chart may seem to be from its place
constexpr double kMostReachM = 2;  // on a car
constexpr double kClickSigmaPx = 0.5;

Fragment clicked_fragment(size_t camera, size_t chart, const CalibrationInput& input,
                          const ChartPattern& pattern) {
  Fragment fragment;
  fragment.known.chart = chart;
  for (const auto& click : input.clicked) {
    if (click.camera != camera || click.chart != chart) continue;
    const ChartCorner& corner = pattern.corners[static_cast<size_t>(click.corner)];
    fragment.corners.push_back({corner.place_m, corner.dark, click.pixel,
                                kClickSigmaPx * kClickSigmaPx * Eigen::Matrix2d::Identity()});
    fragment.known.corner.push_back(click.corner);
  }
  return fragment;
}

/// The pose most of a camera's corners on charts with a pose agree on.
void start_from_posed_charts(const geometry::Camera& camera, size_t index,
                             const std::vector<ChartPattern>& patterns, NamedCorners& named) {
  std::vector<geometry::Sighting> sightings;
  for (const auto& seen : named.corners) {
    const UnknownChart& chart = named.estimate.charts[seen.chart];
    if (seen.camera != index || !chart.fixed) continue;
    const Vector2d ground =
        chart.vehicle_from_chart * patterns[seen.chart].corners[static_cast<size_t>(seen.corner)].place_m;
    sightings.push_back({{ground.x(), ground.y(), 0}, seen.pixel});
  }
  if (const auto agreed = agreed_pose(*camera.lens, sightings))
    named.estimate.cameras[index].vehicle_from_camera = agreed->vehicle_from_camera;
}

size_t corners_of(const std::vector<Fragment>& fragments) {
  size_t count = 0;
  for (const auto& fragment : fragments) count += fragment.corners.size();
  return count;
}

/// Pieces found by one pose of the camera, and the pose they make of it.
struct Search {
  std::vector<Fragment> fragments;
  Levelled levelled;

  size_t corners() const { return corners_of(levelled.fragments); }
};

Search search_from(geometry::Camera camera, const Rigid3& pose, const PosePrior& prior, const cv::Mat& grey,
                   const std::vector<Chart>& charts) {
  camera.vehicle_from_camera = pose;
  Search search;
  search.fragments = find_fragments(camera, grey, charts);
  search.levelled = level_camera(camera, prior, search.fragments);
  return search;
}

/// Where next to nothing is found, the nominal pose may have turned it out of the lens's field: the best of
/// poses turned about the vehicle's axes.
Search search_around(const geometry::Camera& camera, const PosePrior& prior, const cv::Mat& grey,
                     const std::vector<Chart>& charts) {
  Search best;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      const Eigen::Vector3d turn_rad = sign * prior.sigma_rad * Eigen::Vector3d::Unit(axis);
      const Rigid3 turned =
          geometry::turned_and_shifted(camera.vehicle_from_camera, turn_rad, Eigen::Vector3d::Zero());
      Search search = search_from(camera, turned, prior, grey, charts);
      if (search.corners() > best.corners()) best = std::move(search);
    }
  }
  return best;
}

/// Far off, a pose that is degrees wrong stretches squares beyond recognition; one that near squares have set
/// right does not.
std::vector<Fragment> search_twice(const geometry::Camera& camera, const cv::Mat& grey,
                                   const CalibrationInput& input) {
  constexpr double kMuchDeg = 0.7;
  constexpr size_t kNextToNothing = 8;
  const auto tolerance = input.tolerance.value_or(tape_tolerance(input.nominal.vehicle));
  const PosePrior prior = pose_prior(camera, tolerance);
  Search first = search_from(camera, camera.vehicle_from_camera, prior, grey, input.charts);
  if (first.corners() < kNextToNothing) {
    Search around = search_around(camera, prior, grey, input.charts);
    if (around.corners() > first.corners()) first = std::move(around);
  }
  const Rigid3& levelled = first.levelled.vehicle_from_camera;
  if (levelled.rotation.angularDistance(camera.vehicle_from_camera.rotation) < geometry::radians(kMuchDeg))
    return first.fragments;
  Search second = search_from(camera, levelled, prior, grey, input.charts);
  return second.corners() > first.corners() ? second.fragments : first.fragments;
}

}  // namespace

std::vector<Fragment> fragments_of(size_t camera, const cv::Mat& grey, const CalibrationInput& input,
                                   const std::vector<ChartPattern>& patterns) {
  constexpr size_t kLeastCorners = 4;
  std::vector<Fragment> clicked;
  for (size_t chart = 0; chart < patterns.size(); ++chart) {
    Fragment fragment = clicked_fragment(camera, chart, input, patterns[chart]);
    if (fragment.corners.size() >= kLeastCorners) clicked.push_back(std::move(fragment));
  }
  if (!clicked.empty() || grey.empty()) return clicked;
  return search_twice(input.nominal.cameras[camera], grey, input);
}

NamedCorners name_corners(const CalibrationInput& input, std::vector<std::vector<Fragment>> fragments,
                          const std::vector<ChartPattern>& patterns) {
  const geometry::Rig& nominal = input.nominal;
  const NominalTolerance tolerance = input.tolerance.value_or(tape_tolerance(nominal.vehicle));
  NamedCorners named;
  std::vector<Levelled> levelled;
  for (size_t c = 0; c < nominal.cameras.size(); ++c) {
    const PosePrior prior = pose_prior(nominal.cameras[c], tolerance);
    const size_t pieces = fragments[c].size();
    levelled.push_back(level_camera(nominal.cameras[c], prior, std::move(fragments[c])));
    named.unexplained.push_back(static_cast<int>(pieces - levelled.back().fragments.size()));
    named.estimate.cameras.push_back(
        {levelled.back().vehicle_from_camera, nominal.cameras[c].lens, prior, std::nullopt});
  }
  const double reach_m =
      std::min(kChartReach * tolerance.position_m, kMostReachM * scale_of(nominal.vehicle));
  const ChartAssignment assigned = assign_charts(
      levelled, patterns, {geometry::radians(tolerance.rotation_deg), tolerance.position_m}, reach_m);
  named.contradictions = assigned.contradictions;
  for (size_t c = 0; c < assigned.named.size(); ++c) {
    for (const auto& corner : assigned.named[c])
      named.corners.push_back({c, corner.chart, corner.corner, corner.pixel, corner.covariance_px2});
  }
  for (size_t k = 0; k < patterns.size(); ++k) {
    const bool fixed = patterns[k].chart.vehicle_from_chart.has_value();
    named.estimate.charts.push_back({assigned.vehicle_from_chart[k].value_or(geometry::Pose2()), fixed});
    named.placed.push_back(assigned.vehicle_from_chart[k].has_value());
  }
  for (size_t c = 0; c < nominal.cameras.size(); ++c)
    start_from_posed_charts(nominal.cameras[c], c, patterns, named);
  return named;
}

PosePrior pose_prior(const geometry::Camera& camera, const NominalTolerance& tolerance) {
  return {camera.vehicle_from_camera, geometry::radians(tolerance.rotation_deg), tolerance.position_m};
}

NominalTolerance tape_tolerance(const geometry::Vehicle& vehicle) {
  constexpr double kRotationDeg = 3;
  constexpr double kPositionM = 0.05;
  return {kRotationDeg, scale_of(vehicle) * kPositionM};
}

}  // namespace svchain::calibration
