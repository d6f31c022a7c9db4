#include "algorithms/calibration/content_start.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/corner_search.h"
#include "algorithms/calibration/grey_pictures.h"
#include "algorithms/calibration/levelling.h"
#include "algorithms/geometry/angles.h"

namespace svchain::calibration {

namespace {

using geometry::Camera;
using geometry::Pose2;
using geometry::Rigid3;

constexpr double kMirrorsForward = 0.15;  // of the length: where side cameras usually are, before the middle
const std::vector<double> kPitchesDeg = {15, 30, 45, 60, 75};
const std::vector<double> kHeights = {0.15, 0.21, 0.3, 0.42};  // of the vehicle's length

/// How well a pose made here is known, per axis.
NominalTolerance content_tolerance(const geometry::Vehicle& vehicle) {
  constexpr double kRotationDeg = 8;
  constexpr double kPositionM = 0.3;
  return {kRotationDeg, scale_of(vehicle) * kPositionM};
}

/// Looking out level at the middle of a side of the vehicle, turned down by `pitch_deg`.
Rigid3 looking_out(const std::string& name, const geometry::Vehicle& vehicle, double pitch_deg,
                   double height_m) {
  struct Side {
    double yaw_deg;
    Eigen::Vector2d place_m;
  };
  const double ahead = vehicle.length_m / 2, aside = vehicle.width_m / 2;
  const double mirror = kMirrorsForward * vehicle.length_m;
  const Side side = name == "front"   ? Side{0, {ahead, 0}}
                    : name == "right" ? Side{-90, {mirror, -aside}}
                    : name == "rear"  ? Side{180, {-ahead, 0}}
                                      : Side{90, {mirror, aside}};
  Eigen::Matrix3d level;  // looks along x: right is -y, down is -z
  level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(geometry::radians(side.yaw_deg), Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(geometry::radians(pitch_deg), Eigen::Vector3d::UnitY()).toRotationMatrix() * level;
  return {Eigen::Quaterniond(rotation), {side.place_m.x(), side.place_m.y(), height_m}};
}

/// How much of the charts these pieces show: their corners that a chart explains, less where that is a part
/// of the chart only, for a part of a larger chart may be all of a smaller one seen from higher up.
double explained(const std::vector<Fragment>& fragments, const std::vector<ChartPattern>& patterns) {
  double sum = 0;
  for (const auto& fragment : fragments) {
    double best = 0;
    for (const auto& identity : identities(fragment, patterns)) {
      const auto all = static_cast<double>(patterns[identity.chart].corners.size());
      best = std::max(best, identity.score * std::sqrt(identity.score / all));
    }
    sum += best;
  }
  return sum;
}

struct Way {
  Rigid3 vehicle_from_camera;
  double score = 0;
};

/// The ways of looking out whose pictures, laid on the ground, show most of the charts' patterns.
std::vector<Way> promising_ways(Camera camera, const cv::Mat& grey, const CalibrationInput& input,
                                const std::vector<ChartPattern>& patterns) {
  constexpr size_t kMost = 7;
  std::vector<Way> ways;
  for (const double height : kHeights) {
    for (const double pitch_deg : kPitchesDeg) {
      camera.vehicle_from_camera =
          looking_out(camera.name, input.nominal.vehicle, pitch_deg, height * input.nominal.vehicle.length_m);
      ways.push_back(
          {camera.vehicle_from_camera, explained(find_patterns(camera, grey, input.charts), patterns)});
    }
  }
  std::stable_sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.score > b.score; });
  ways.resize(std::min(ways.size(), kMost));
  return ways;
}

/// Twice: laid on the ground by a better pose, a picture shows more.
Way levelled(Camera camera, const cv::Mat& grey, const CalibrationInput& input,
             const std::vector<ChartPattern>& patterns) {
  Way way{camera.vehicle_from_camera, 0};
  for (int round = 0; round < 2; ++round) {
    const PosePrior prior = pose_prior(camera, content_tolerance(input.nominal.vehicle));
    const Levelled found = level_camera(camera, prior, find_fragments(camera, grey, input.charts));
    camera.vehicle_from_camera = found.vehicle_from_camera;
    way = {found.vehicle_from_camera, explained(found.fragments, patterns)};
  }
  return way;
}

/// All cameras together, the charts wherever they lie: told apart by all pictures at once.
Calibration with_charts_anywhere(CalibrationInput input) {
  for (auto& chart : input.charts) chart.vehicle_from_chart.reset();
  return calibrate(input);
}

/// Moves the cameras as one so that the charts come to lie where they are said to. Nothing where none is, or
/// where they do not lie to each other as they should.
std::optional<Pose2> motion_to(const std::vector<Chart>& said, const std::vector<Chart>& found,
                               double near_m) {
  std::vector<Eigen::Vector2d> from, to;
  for (size_t k = 0; k < said.size(); ++k) {
    if (!said[k].vehicle_from_chart || !found[k].vehicle_from_chart) continue;
    for (const auto& corner : corners(said[k])) {
      from.push_back(*found[k].vehicle_from_chart * corner.place_m);
      to.push_back(*said[k].vehicle_from_chart * corner.place_m);
    }
  }
  if (from.empty()) return std::nullopt;
  const Pose2 motion = pose_between(from, to);
  for (size_t i = 0; i < from.size(); ++i) {
    if ((motion * from[i] - to[i]).norm() > near_m) return std::nullopt;
  }
  return motion;
}

Rigid3 moved(const Pose2& motion, const Rigid3& pose) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(motion.yaw_rad, Eigen::Vector3d::UnitZ()));
  return Rigid3{turn, {motion.x_m, motion.y_m, 0}} * pose;
}

/// Puts the cameras where all pictures together have them.
void start_from_all(CalibrationInput& input) {
  const Calibration rough = with_charts_anywhere(input);
  const bool all_seen = std::all_of(rough.cameras.begin(), rough.cameras.end(),
                                    [](const auto& camera) { return camera.inliers > 0; });
  const NominalTolerance tape = tape_tolerance(input.nominal.vehicle);
  const auto motion = motion_to(input.charts, rough.charts, 4 * tape.position_m);
  if (!all_seen || !motion) return;
  for (size_t c = 0; c < rough.rig.cameras.size(); ++c)
    input.nominal.cameras[c].vehicle_from_camera = moved(*motion, rough.rig.cameras[c].vehicle_from_camera);
  input.tolerance = tape;
}

}  // namespace

void start_from_content(CalibrationInput& input) {
  const std::vector<cv::Mat> greys = grey_pictures(input);
  const auto patterns = patterns_of(input.charts);
  for (size_t c = 0; c < input.nominal.cameras.size(); ++c) {
    Camera camera = input.nominal.cameras[c];
    Way best;
    for (const Way& way : promising_ways(camera, greys[c], input, patterns)) {
      camera.vehicle_from_camera = way.vehicle_from_camera;
      const Way found = levelled(camera, greys[c], input, patterns);
      if (best.score == 0 || found.score > best.score) best = found;
    }
    input.nominal.cameras[c].vehicle_from_camera = best.vehicle_from_camera;
  }
  input.tolerance = content_tolerance(input.nominal.vehicle);
  const bool any_posed = std::any_of(input.charts.begin(), input.charts.end(),
                                     [](const Chart& chart) { return chart.vehicle_from_chart.has_value(); });
  if (any_posed) start_from_all(input);
}

}  // namespace svchain::calibration
