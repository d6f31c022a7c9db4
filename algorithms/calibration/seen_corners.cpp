#include "algorithms/calibration/seen_corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace svchain::calibration {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kMostRounds = 8;
constexpr double kSettled = 0.05;  // change of a spread, of itself
constexpr double kHuber = 2;       // sigmas from which on a corner counts less
constexpr double kGate = 5;        // sigmas beyond which it does not agree
constexpr double kLeastGatePx = 0.25;
constexpr double kLeastSpreadPx = 0.006;  // what no model of a corner is better than
constexpr double kStartSpreadPx = 0.5;
constexpr double kFarPx = 1e3;  // of what cannot be seen

/// One round of fitting: what came out and what is left of each corner.
struct Round {
  JointSolution solution;
  std::vector<double> spread_px;  // by camera: the scatter beyond the corners' own uncertainty
  std::vector<Vector2d> left_px;
};

bool fits(const SeenCorner& seen) {
  return !seen.held_out && !seen.rejected;
}

Matrix2d expected_covariance(const SeenCorner& seen, const std::vector<double>& spread_px) {
  return seen.covariance_px2 + spread_px[seen.camera] * spread_px[seen.camera] * Matrix2d::Identity();
}

/// How far off a corner is, in its own sigmas.
double sigmas_off(const Vector2d& left_px, const Matrix2d& covariance_px2) {
  return std::sqrt(left_px.dot(covariance_px2.llt().solve(left_px)));
}

std::vector<Vector2d> what_is_left(const JointSolution& solution, const std::vector<SeenCorner>& corners,
                                   const std::vector<ChartPattern>& patterns) {
  std::vector<Vector2d> left_px;
  for (const auto& seen : corners) {
    left_px.push_back(
        residual_px(sighting_of(seen, patterns), solution.cameras[seen.camera], solution.charts[seen.chart])
            .value_or(Vector2d::Constant(kFarPx)));
  }
  return left_px;
}

JointProblem problem_of(const Round& last, const std::vector<SeenCorner>& corners,
                        const std::vector<ChartPattern>& patterns) {
  JointProblem problem{last.solution.cameras, last.solution.charts, {}};
  for (size_t i = 0; i < corners.size(); ++i) {
    if (!fits(corners[i])) continue;
    CornerSighting sighting = sighting_of(corners[i], patterns);
    sighting.covariance_px2 = expected_covariance(corners[i], last.spread_px);
    if (!last.left_px.empty())
      sighting.covariance_px2 *= std::max(1.0, sigmas_off(last.left_px[i], sighting.covariance_px2) / kHuber);
    problem.sightings.push_back(sighting);
  }
  return problem;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Share of a camera's rows that its unknowns leave free: the fewer, the closer a fit comes to any corners.
double freedom(size_t camera, const JointSolution& solution, const std::vector<SeenCorner>& corners) {
  const auto own = std::count_if(corners.begin(), corners.end(), [&](const SeenCorner& seen) {
    return seen.camera == camera && !seen.held_out;
  });
  const double rows = std::max(2.0 * static_cast<double>(own), 1.0);
  return std::max(rows - static_cast<double>(solution.covariance[camera].rows()), 1.0) / rows;
}

/// Marks a camera's corners anew; whether that changes any. In its own sigmas a corner's distance is Rayleigh
/// distributed, its median 1.177.
bool reject_outliers(size_t camera, const Round& round, std::vector<SeenCorner>& corners) {
  constexpr double kMedianOfRayleigh = 1.177;
  std::vector<double> sigmas(corners.size()), own;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera != camera) continue;
    sigmas[i] = sigmas_off(round.left_px[i], expected_covariance(corners[i], round.spread_px));
    if (!corners[i].held_out) own.push_back(sigmas[i]);
  }
  const double usual = median(own) / kMedianOfRayleigh / std::sqrt(freedom(camera, round.solution, corners));
  bool changed = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera != camera) continue;
    const bool far = sigmas[i] > kGate * std::max(1.0, usual) && round.left_px[i].norm() > kLeastGatePx;
    changed = changed || far != corners[i].rejected;
    corners[i].rejected = far;
  }
  return changed;
}

double rms_px(size_t camera, const Round& round, const std::vector<SeenCorner>& corners) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].camera != camera || !fits(corners[i])) continue;
    sum += round.left_px[i].squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// What the corners that agree scatter beyond their fits' uncertainty, per axis.
double spread_px(size_t camera, const Round& round, const std::vector<SeenCorner>& corners) {
  double fit = 0, count = 0;
  for (const auto& seen : corners) {
    if (seen.camera != camera || !fits(seen)) continue;
    fit += seen.covariance_px2.trace() / 2;
    ++count;
  }
  if (count == 0) return kStartSpreadPx;
  const double rms = rms_px(camera, round, corners);
  const double variance = rms * rms / 2 / freedom(camera, round.solution, corners) - fit / count;
  return std::sqrt(std::max(variance, kLeastSpreadPx * kLeastSpreadPx));
}

}  // namespace

CornerSighting sighting_of(const SeenCorner& seen, const std::vector<ChartPattern>& patterns) {
  const auto& corner = patterns[seen.chart].corners[static_cast<size_t>(seen.corner)];
  return {seen.camera, seen.chart, corner.place_m, seen.pixel, seen.covariance_px2};
}

FittedEstimate fit(const Estimate& start, std::vector<SeenCorner>& corners,
                   const std::vector<ChartPattern>& patterns) {
  const size_t cameras = start.cameras.size();
  Round round{{start.cameras, start.charts, {}, {}}, std::vector<double>(cameras, kStartSpreadPx), {}};
  for (int i = 0; i < kMostRounds; ++i) {
    round.solution = refine_jointly(problem_of(round, corners, patterns));
    round.left_px = what_is_left(round.solution, corners, patterns);
    bool settled = true;
    for (size_t c = 0; c < cameras; ++c) {
      settled = !reject_outliers(c, round, corners) && settled;
      const double before = std::exchange(round.spread_px[c], spread_px(c, round, corners));
      settled = settled && std::abs(round.spread_px[c] - before) <= kSettled * before;
    }
    if (settled) break;
  }
  FittedEstimate fitted;
  for (size_t c = 0; c < cameras; ++c) {
    fitted.rms_px.push_back(rms_px(c, round, corners));
    fitted.scatter_px.push_back(fitted.rms_px.back() / std::sqrt(freedom(c, round.solution, corners)));
  }
  fitted.solution = std::move(round.solution);
  return fitted;
}

}  // namespace svchain::calibration
