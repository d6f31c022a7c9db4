#include "algorithms/calibration/diagnosis.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "algorithms/calibration/second_look.h"

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;

std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

/// Whether the straight way from a camera to a place leads over the vehicle, whose body then may hide it.
bool over_vehicle(const Vector2d& from, const Vector2d& to, const geometry::Vehicle& vehicle) {
  constexpr int kSteps = 50;
  constexpr double kInside = 0.45;  // of the length and width: a camera stands on the edge itself
  for (int i = 1; i <= kSteps; ++i) {
    const Vector2d at = from + (to - from) * i / kSteps;
    if (std::abs(at.x()) < kInside * vehicle.length_m && std::abs(at.y()) < kInside * vehicle.width_m)
      return true;
  }
  return false;
}

/// Whether a camera should see all of a chart, well enough to find it.
bool should_see(const geometry::Camera& camera, const Chart& chart, const geometry::Vehicle& vehicle) {
  constexpr double kWellPx = 6;
  for (const auto& corner : corners(chart)) {
    const auto expected = expect(camera, corner, *chart.vehicle_from_chart);
    if (!expected || expected->least_edge_px() < kWellPx) return false;
    if (over_vehicle(camera.vehicle_from_camera.translation.head<2>(),
                     *chart.vehicle_from_chart * corner.place_m, vehicle))
      return false;
  }
  return true;
}

/// Cameras that have found some corners of each chart, by chart.
std::vector<std::vector<bool>> views(const Calibration& calibration) {
  constexpr int kSome = 4;
  std::vector<std::vector<int>> count(calibration.charts.size(),
                                      std::vector<int>(calibration.rig.cameras.size(), 0));
  for (const auto& corner : calibration.corners) {
    const bool found = corner.state == CornerState::kFitted || corner.state == CornerState::kHeldOut;
    count[corner.chart][corner.camera] += found;
  }
  std::vector<std::vector<bool>> seen;
  for (const auto& cameras : count) {
    seen.emplace_back();
    for (const int corners : cameras) seen.back().push_back(corners >= kSome);
  }
  return seen;
}

/// Cameras whose place relative to the rest nothing tells. Charts with a pose tell it, and those that are
/// shared with a camera that is told.
std::vector<bool> tied_cameras(const NamedCorners& named, const std::vector<std::vector<bool>>& seen) {
  const bool any_posed = std::any_of(named.estimate.charts.begin(), named.estimate.charts.end(),
                                     [](const UnknownChart& chart) { return chart.fixed; });
  std::vector<bool> tied(named.estimate.cameras.size(), false), told;
  if (!any_posed) tied[0] = true;
  for (const auto& chart : named.estimate.charts) told.push_back(chart.fixed);
  for (size_t round = 0; round < tied.size() + told.size(); ++round) {
    for (size_t k = 0; k < told.size(); ++k) {
      for (size_t c = 0; c < tied.size(); ++c) {
        if (!seen[k][c]) continue;
        if (told[k]) tied[c] = true;
        if (tied[c]) told[k] = true;
      }
    }
  }
  return tied;
}

int agreeing_corners(const CalibrationInput& input, const std::vector<std::vector<Fragment>>& fragments,
                     const std::vector<ChartPattern>& patterns) {
  NamedCorners named = name_corners(input, fragments, patterns);
  constexpr double kAgreePx = 3;
  const FittedEstimate fitted = fit(named.estimate, named.corners, patterns);
  int agreeing = 0;
  for (const auto& corner : named.corners) {
    const bool shared = std::any_of(named.corners.begin(), named.corners.end(), [&](const SeenCorner& other) {
      return other.chart == corner.chart && other.camera != corner.camera;
    });
    const auto off = residual_px(sighting_of(corner, patterns), fitted.solution.cameras[corner.camera],
                                 fitted.solution.charts[corner.chart]);
    const bool near = off && off->norm() < kAgreePx;
    agreeing += near && (shared || named.estimate.charts[corner.chart].fixed);
  }
  return agreeing;
}

}  // namespace

std::vector<std::string> missing_views(const Calibration& calibration, const NamedCorners& named) {
  const auto& cameras = calibration.rig.cameras;
  const auto seen = views(calibration);
  std::vector<std::string> reasons;
  for (size_t k = 0; k < calibration.charts.size(); ++k) {
    const Chart& chart = calibration.charts[k];
    std::vector<std::string> by, missing;
    for (size_t c = 0; c < cameras.size(); ++c) {
      if (seen[k][c])
        by.push_back(cameras[c].name);
      else if (chart.vehicle_from_chart && should_see(cameras[c], chart, calibration.rig.vehicle))
        missing.push_back(cameras[c].name);
    }
    if (by.empty())
      reasons.push_back("chart " + quoted(chart.name) + " is seen by no camera");
    else if (by.size() == 1 && !missing.empty())
      reasons.push_back("chart " + quoted(chart.name) + " is seen by " + by.front() + " only, expected " +
                        spoken_list(missing) + " as well");
  }
  const auto tied = tied_cameras(named, seen);
  for (size_t c = 0; c < cameras.size(); ++c) {
    if (!tied[c]) reasons.push_back(cameras[c].name + " shares no chart with the other cameras");
  }
  return reasons;
}

std::vector<std::string> mistaken_pictures(const CalibrationInput& input, const std::vector<cv::Mat>& greys,
                                           const std::vector<std::vector<Fragment>>& as_given,
                                           const std::vector<ChartPattern>& patterns) {
  constexpr int kClearly = 8;  // corners
  const auto& cameras = input.nominal.cameras;
  int best = agreeing_corners(input, as_given, patterns) + kClearly;
  std::vector<std::string> reasons;
  const auto consider = [&](std::vector<std::vector<Fragment>> fragments, const std::string& reason) {
    const int agreeing = agreeing_corners(input, fragments, patterns);
    if (agreeing < best) return;
    best = agreeing + 1;
    reasons = {reason};
  };
  for (size_t c = 0; c < cameras.size(); ++c) {
    cv::Mat mirrored;
    cv::flip(greys[c], mirrored, 1);
    auto fragments = as_given;
    fragments[c] = fragments_of(c, mirrored, input, patterns);
    consider(std::move(fragments), "the picture of " + cameras[c].name + " looks mirrored");
  }
  for (size_t a = 0; a < cameras.size(); ++a) {
    for (size_t b = a + 1; b < cameras.size(); ++b) {
      if (cameras[a].image_size_px != cameras[b].image_size_px) continue;
      auto fragments = as_given;
      fragments[a] = fragments_of(a, greys[b], input, patterns);
      fragments[b] = fragments_of(b, greys[a], input, patterns);
      consider(std::move(fragments),
               "the pictures of " + cameras[a].name + " and " + cameras[b].name + " look swapped");
    }
  }
  return reasons;
}

}  // namespace svchain::calibration
