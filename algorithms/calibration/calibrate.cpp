#include <algorithm>
#include <chrono>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/camera_pose.h"
#include "algorithms/calibration/chart_assignment.h"
#include "algorithms/calibration/second_look.h"
#include "algorithms/geometry/angles.h"

namespace svchain::calibration {

namespace {

using geometry::Camera;
using geometry::Rigid3;

constexpr double kNominalSigmaDeg = 3;   // what a rig measured by tape is good to, per axis
constexpr double kNominalSigmaM = 0.05;  // on a car
constexpr double kChartReachM = 1.0;     // on a car: how far a chart may seem to be from its place
constexpr double kLensFitsPx = 0.15;     // corners that scatter more are worth a better lens
constexpr double kWorthALens = 0.8;      // of the scatter with the lens as it was given
constexpr double kLensPriorPx = 3;

class Stages {
 public:
  explicit Stages(Calibration& calibration) : calibration_(calibration) {}
  void done(const std::string& name) {
    const auto now = std::chrono::steady_clock::now();
    calibration_.stage_ms.emplace_back(name, std::chrono::duration<double, std::milli>(now - last_).count());
    last_ = now;
  }

 private:
  Calibration& calibration_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

cv::Mat grey_of(const cv::Mat& picture) {
  if (picture.channels() == 1) return picture;
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

PosePrior prior_of(const Camera& camera, double scale) {
  return {camera.vehicle_from_camera, geometry::radians(kNominalSigmaDeg), scale * kNominalSigmaM};
}

/// One calibration under way.
class Run {
 public:
  explicit Run(const CalibrationInput& input)
      : input_(input), patterns_(patterns_of(input.charts)), scale_(scale_of(input.nominal.vehicle)) {
    for (const auto& picture : input.pictures) greys_.push_back(grey_of(picture));
  }

  Calibration make() {
    Calibration made;
    Stages stages(made);
    find(stages);
    refine();
    stages.done("joint refinement");
    look_again();
    stages.done("second look");
    refine();
    look_again();
    refine();
    stages.done("final refinement");
    write(made);
    judge(input_, fitted_, seen_, patterns_, {}, made);
    add_records(made);
    stages.done("accuracy");
    return made;
  }

 private:
  void find(Stages& stages) {
    std::vector<std::vector<Fragment>> fragments;
    for (size_t c = 0; c < cameras().size(); ++c)
      fragments.push_back(find_fragments(cameras()[c], greys_[c], input_.charts));
    stages.done("corners");
    std::vector<Levelled> levelled;
    for (size_t c = 0; c < cameras().size(); ++c)
      levelled.push_back(level_camera(cameras()[c], prior_of(cameras()[c], scale_), std::move(fragments[c])));
    assignment_ = assign_charts(levelled, patterns_, scale_ * kChartReachM);
    for (size_t c = 0; c < cameras().size(); ++c) {
      for (const auto& named : assignment_.named[c])
        seen_.push_back({c, named.chart, named.corner, named.pixel, named.covariance_px2, false, false});
      estimate_.cameras.push_back(
          {levelled[c].vehicle_from_camera, cameras()[c].lens, prior_of(cameras()[c], scale_), {}});
    }
    for (size_t k = 0; k < patterns_.size(); ++k) {
      const bool fixed = patterns_[k].chart.vehicle_from_chart.has_value();
      estimate_.charts.push_back({assignment_.vehicle_from_chart[k].value_or(geometry::Pose2()), fixed});
      placed_.push_back(assignment_.vehicle_from_chart[k].has_value());
    }
    stages.done("names");
    for (size_t c = 0; c < cameras().size(); ++c) start_pose(c);
    stages.done("poses");
  }

  /// The pose most of the corners of charts with a pose agree on.
  void start_pose(size_t c) {
    std::vector<geometry::Sighting> sightings;
    for (const auto& seen : seen_) {
      if (seen.camera != c || !estimate_.charts[seen.chart].fixed) continue;
      const auto ground = estimate_.charts[seen.chart].vehicle_from_chart *
                          patterns_[seen.chart].corners[static_cast<size_t>(seen.corner)].place_m;
      sightings.push_back({{ground.x(), ground.y(), 0}, seen.pixel});
    }
    if (const auto agreed = agreed_pose(*cameras()[c].lens, sightings))
      estimate_.cameras[c].vehicle_from_camera = agreed->vehicle_from_camera;
  }

  void hold_out() {
    if (input_.hold_out == HoldOut::kNone) return;
    const int held = input_.hold_out == HoldOut::kEven ? 0 : 1;
    for (auto& seen : seen_) seen.held_out = seen.corner % 2 == held;
  }

  /// With the lenses as they are given; where corners do not fit that well, with better ones.
  void refine() {
    hold_out();
    for (size_t c = 0; c < cameras().size(); ++c) {
      estimate_.cameras[c].lens = cameras()[c].lens;
      estimate_.cameras[c].lens_prior.reset();
    }
    refit();
    const FittedEstimate kept = fitted_;
    const auto free_lenses = [&](auto wanted) {
      bool any = false;
      for (size_t c = 0; c < cameras().size(); ++c) {
        UnknownCamera& camera = estimate_.cameras[c];
        camera.lens_prior.reset();
        if (wanted(c)) camera.lens_prior = LensKnowledge{cameras()[c].lens, kLensPriorPx};
        if (!camera.lens_prior) camera.lens = cameras()[c].lens;
        any = any || camera.lens_prior;
      }
      return any;
    };
    if (!free_lenses([&](size_t c) { return kept.rms_px[c] > kLensFitsPx; })) return;
    refit();
    const FittedEstimate freed = fitted_;
    free_lenses([&](size_t c) { return freed.rms_px[c] < kWorthALens * kept.rms_px[c]; });
    refit();
  }

  void refit() {
    for (auto& seen : seen_) seen.rejected = false;
    fitted_ = fit(estimate_, seen_, patterns_);
    estimate_ = {fitted_.solution.cameras, fitted_.solution.charts};
  }

  Camera calibrated(size_t c) const {
    Camera camera = cameras()[c];
    camera.vehicle_from_camera = fitted_.solution.cameras[c].vehicle_from_camera;
    camera.lens = fitted_.solution.cameras[c].lens;
    return camera;
  }

  void look_again() {
    std::vector<SeenCorner> seen;
    for (size_t c = 0; c < cameras().size(); ++c) {
      const double reach_px = 1.5 + 4 * fitted_.rms_px[c];
      const auto found = calibration::look_again(c, calibrated(c), greys_[c], patterns_,
                                                 fitted_.solution.charts, placed_, seen_, reach_px);
      seen.insert(seen.end(), found.begin(), found.end());
    }
    seen_ = std::move(seen);
  }

  void write(Calibration& made) const {
    made.rig = input_.nominal;
    for (size_t c = 0; c < cameras().size(); ++c) made.rig.cameras[c] = calibrated(c);
    made.charts = input_.charts;
    for (size_t k = 0; k < patterns_.size(); ++k) {
      if (placed_[k]) made.charts[k].vehicle_from_chart = fitted_.solution.charts[k].vehicle_from_chart;
    }
  }

  void add_records(Calibration& made) const {
    for (size_t c = 0; c < cameras().size(); ++c) {
      const Camera camera = calibrated(c);
      for (size_t k = 0; k < patterns_.size(); ++k) {
        for (size_t i = 0; placed_[k] && i < patterns_[k].corners.size(); ++i) {
          const auto expected =
              expect(camera, patterns_[k].corners[i], fitted_.solution.charts[k].vehicle_from_chart);
          if (!expected) continue;
          made.corners.push_back(
              {c, k, static_cast<int>(i), CornerState::kNotFound, expected->pixel, {0, 0}});
          for (const auto& seen : seen_) {
            if (seen.camera != c || seen.chart != k || seen.corner != static_cast<int>(i)) continue;
            made.corners.back().found_px = seen.pixel;
            made.corners.back().state = seen.rejected   ? CornerState::kRejected
                                        : seen.held_out ? CornerState::kHeldOut
                                                        : CornerState::kFitted;
          }
        }
      }
    }
  }

  const std::vector<Camera>& cameras() const { return input_.nominal.cameras; }

  const CalibrationInput& input_;
  std::vector<ChartPattern> patterns_;
  double scale_;
  std::vector<cv::Mat> greys_;
  ChartAssignment assignment_;
  std::vector<SeenCorner> seen_;
  std::vector<bool> placed_;  // charts that have been seen, or have a pose
  Estimate estimate_;
  FittedEstimate fitted_;
};

}  // namespace

bool Calibration::accepted() const {
  return reasons.empty() &&
         std::all_of(cameras.begin(), cameras.end(), [](const auto& c) { return c.reasons.empty(); });
}

Calibration calibrate(const CalibrationInput& input) {
  return Run(input).make();
}

}  // namespace svchain::calibration
