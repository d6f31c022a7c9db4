#include "algorithms/calibration/seen_corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace svchain::calibration {

namespace {

constexpr int kMostRounds = 6;
constexpr double kSameSpread = 0.05;
constexpr double kGate = 4;               // sigmas beyond which a corner does not agree
constexpr double kLeastSpreadPx = 0.02;   // what no model of a corner is better than
constexpr double kLeastGatePx = 0.25;
constexpr double kStartSpreadPx = 0.5;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

JointProblem problem_of(const Estimate& estimate, const std::vector<SeenCorner>& corners,
                        const std::vector<ChartPattern>& patterns, const std::vector<double>& spread_px) {
  JointProblem problem{estimate.cameras, estimate.charts, {}};
  for (const auto& seen : corners) {
    if (seen.held_out || seen.rejected) continue;
    CornerSighting sighting = sighting_of(seen, patterns);
    sighting.covariance_px2 += spread_px[seen.camera] * spread_px[seen.camera] * Eigen::Matrix2d::Identity();
    problem.sightings.push_back(sighting);
  }
  return problem;
}

/// Distances in px of all corners of a camera from where they should be; what cannot be seen is far.
std::vector<double> distances_px(const JointSolution& solution, const std::vector<SeenCorner>& corners,
                                 const std::vector<ChartPattern>& patterns) {
  constexpr double kFarPx = 1e3;
  std::vector<double> distances;
  for (const auto& seen : corners) {
    const auto off = residual_px(sighting_of(seen, patterns), solution.cameras[seen.camera],
                                 solution.charts[seen.chart]);
    distances.push_back(off ? off->norm() : kFarPx);
  }
  return distances;
}

/// Marks a camera's corners anew; whether that changes any. A corner's distance is Rayleigh distributed: its
/// median is 1.177 sigma.
bool reject_outliers(const std::vector<double>& distances, size_t camera, std::vector<SeenCorner>& corners) {
  constexpr double kMedianOfRayleigh = 1.177;
  std::vector<double> own;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera == camera && !corners[i].held_out) own.push_back(distances[i]);
  }
  const double sigma = median(own) / kMedianOfRayleigh;
  bool changed = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera != camera) continue;
    const double fit_sigma = std::sqrt(corners[i].covariance_px2.trace() / 2);
    const bool far = distances[i] > std::max(kLeastGatePx, kGate * std::hypot(sigma, fit_sigma));
    changed = changed || far != corners[i].rejected;
    corners[i].rejected = far;
  }
  return changed;
}

/// What the inliers scatter beyond their fits' uncertainty, the fit's own freedom allowed for.
double spread_of(const std::vector<double>& distances, size_t camera, const std::vector<SeenCorner>& corners,
                 double unknowns) {
  double square = 0, explained = 0, rows = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera != camera || corners[i].held_out || corners[i].rejected) continue;
    square += distances[i] * distances[i];
    explained += corners[i].covariance_px2.trace();
    rows += 2;
  }
  if (rows <= unknowns) return kStartSpreadPx;
  const double variance = square / (rows - unknowns) - explained / rows;
  return std::sqrt(std::max(variance, kLeastSpreadPx * kLeastSpreadPx));
}

}  // namespace

CornerSighting sighting_of(const SeenCorner& seen, const std::vector<ChartPattern>& patterns) {
  const auto& corner = patterns[seen.chart].corners[static_cast<size_t>(seen.corner)];
  return {seen.camera, seen.chart, corner.place_m, seen.pixel, seen.covariance_px2};
}

FittedEstimate fit(const Estimate& start, std::vector<SeenCorner>& corners,
                   const std::vector<ChartPattern>& patterns) {
  FittedEstimate fitted{{start.cameras, start.charts, {}, {}},
                        std::vector<double>(start.cameras.size(), kStartSpreadPx)};
  for (int round = 0; round < kMostRounds; ++round) {
    fitted.solution = refine_jointly(
        problem_of({fitted.solution.cameras, fitted.solution.charts}, corners, patterns, fitted.spread_px));
    const auto distances = distances_px(fitted.solution, corners, patterns);
    bool settled = true;
    for (size_t camera = 0; camera < start.cameras.size(); ++camera) {
      const auto unknowns = static_cast<double>(fitted.solution.covariance[camera].rows());
      settled = !reject_outliers(distances, camera, corners) && settled;
      const double before_px = std::exchange(fitted.spread_px[camera], spread_of(distances, camera, corners, unknowns));
      settled = settled && std::abs(fitted.spread_px[camera] / before_px - 1) < kSameSpread;
    }
    if (settled) break;
  }
  return fitted;
}

}  // namespace svchain::calibration
