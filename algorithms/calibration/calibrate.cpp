#include <algorithm>
#include <chrono>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/corner_search.h"
#include "algorithms/calibration/diagnosis.h"
#include "algorithms/calibration/grey_pictures.h"
#include "algorithms/calibration/second_look.h"

namespace svchain::calibration {

namespace {

using geometry::Camera;

constexpr double kLensFitsPx = 0.15;  // corners that scatter more are worth a better lens
constexpr double kWorthALens = 0.8;   // of the scatter with the lens as it was given
constexpr double kLensPriorPx = 3;
constexpr double kMuchForALensPx = 3;

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

/// One calibration under way.
class Run {
 public:
  explicit Run(const CalibrationInput& input)
      : input_(input), patterns_(patterns_of(input.charts)), greys_(grey_pictures(input)) {}

  Calibration make() {
    Calibration made;
    Stages stages(made);
    for (size_t c = 0; c < cameras().size(); ++c)
      fragments_.push_back(fragments_of(c, greys_[c], input_, patterns_));
    stages.done("corners");
    named_ = name_corners(input_, fragments_, patterns_);
    seen_ = named_.corners;
    estimate_ = named_.estimate;
    stages.done("first poses");
    refine();
    look_again();
    stages.done("second look");
    refine();
    look_again();
    refine();
    stages.done("joint refinement");
    write(made);
    judge(input_, fitted_, seen_, patterns_, {}, made);
    add_records(made);
    stages.done("accuracy");
    explain(made);
    return made;
  }

 private:
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
    if (!free_lenses([&](size_t c) { return kept.scatter_px[c] > kLensFitsPx; })) return;
    refit();
    const FittedEstimate freed = fitted_;
    free_lenses([&](size_t c) { return freed.scatter_px[c] < kWorthALens * kept.scatter_px[c]; });
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
      if (greys_[c].empty()) return;
      const double reach_px = 1.5 + 4 * fitted_.rms_px[c];
      const auto found = calibration::look_again(c, calibrated(c), greys_[c], patterns_,
                                                 fitted_.solution.charts, named_.placed, seen_, reach_px);
      seen.insert(seen.end(), found.begin(), found.end());
    }
    seen_ = std::move(seen);
  }

  /// Where something is wrong, what it may be.
  void explain(Calibration& made) const {
    for (auto& reason : missing_views(made, named_)) made.reasons.push_back(std::move(reason));
    if (made.accepted()) return;
    for (size_t c = 0; c < cameras().size(); ++c) {
      auto& reasons = made.cameras[c].reasons;
      if (made.cameras[c].lens_change_px > kMuchForALensPx)
        reasons.push_back("its lens had to change much to fit as well as this: another lens?");
      if (reasons.empty()) continue;
      if (named_.contradictions[c] > 0)
        reasons.push_back(std::to_string(named_.contradictions[c]) +
                          " charts are seen where none should be, or turned round");
      if (named_.unexplained[c] > 0)
        reasons.push_back(std::to_string(named_.unexplained[c]) +
                          " patterns do not lie on the ground as squares: another lens, or another pose?");
      else if (made.cameras[c].points == 0)
        reasons.push_back(
            "nothing like the charts is found: another lens, another pose, or another picture?");
    }
    if (input_.pictures.empty()) return;
    for (auto& reason : mistaken_pictures(input_, greys_, fragments_, patterns_))
      made.reasons.push_back(std::move(reason));
  }

  void write(Calibration& made) const {
    made.rig = input_.nominal;
    for (size_t c = 0; c < cameras().size(); ++c) made.rig.cameras[c] = calibrated(c);
    made.charts = input_.charts;
    for (size_t k = 0; k < patterns_.size(); ++k) {
      if (named_.placed[k]) made.charts[k].vehicle_from_chart = fitted_.solution.charts[k].vehicle_from_chart;
    }
  }

  void add_records(Calibration& made) const {
    for (size_t c = 0; c < cameras().size(); ++c) {
      const Camera camera = calibrated(c);
      for (size_t k = 0; k < patterns_.size(); ++k) {
        for (size_t i = 0; named_.placed[k] && i < patterns_[k].corners.size(); ++i) {
          const auto expected =
              expect(camera, patterns_[k].corners[i], fitted_.solution.charts[k].vehicle_from_chart);
          const SeenCorner* seen = find(seen_, c, k, static_cast<int>(i));
          if (!seen && !(expected && expected->can_be_found())) continue;
          made.corners.push_back({c, k, static_cast<int>(i), state_of(seen),
                                  expected ? expected->pixel : seen->pixel,
                                  seen ? seen->pixel : Eigen::Vector2d(0, 0)});
        }
      }
    }
  }

  static CornerState state_of(const SeenCorner* seen) {
    if (!seen) return CornerState::kNotFound;
    if (seen->rejected) return CornerState::kRejected;
    return seen->held_out ? CornerState::kHeldOut : CornerState::kFitted;
  }

  const std::vector<Camera>& cameras() const { return input_.nominal.cameras; }

  const CalibrationInput& input_;
  std::vector<ChartPattern> patterns_;
  std::vector<cv::Mat> greys_;
  std::vector<std::vector<Fragment>> fragments_;  // by camera
  NamedCorners named_;
  std::vector<SeenCorner> seen_;
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
