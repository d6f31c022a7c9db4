#include "algorithms/registration/alignment.h"

#include <algorithm>
#include <cmath>

#include "algorithms/registration/overlap.h"
#include "algorithms/registration/overlap_match.h"

namespace svchain::registration {

namespace {

constexpr int kLeastSidePx = 16;       // of an image
constexpr double kNoisePx = 1;         // of a feature on the ground, at the scale it is found at ...
constexpr double kLeastNoisePx = 0.1;  // ... and when it has been measured
constexpr double kRejectPx = 5;        // of the view: farther apart no true match is

/// From coarse to fine, in pixels of the view; what is found once is sought again nearer by.
constexpr Fineness kPasses[] = {{2, 2, false}, {2, 2, false}, {2, 2, false}, {1, 1, true}, {1, 1, true}};

Faults faults_of(const AlignmentTask& task) {
  Faults faults;
  for (size_t i = 0; i < 4; ++i) {
    const cv::Mat& frame = task.frames[i];
    const GroundCamera& camera = task.cameras[i];
    const std::string& name = geometry::kCameraNames[i];
    if (frame.depth() != CV_8U || (frame.channels() != 1 && frame.channels() != 3)) {
      faults.push_back({name, {}, "", "the frame is neither grey nor BGR with 8 bits"});
    }
    if (frame.cols != camera.image_size_px.x() || frame.rows != camera.image_size_px.y()) {
      faults.push_back({name,
                        {},
                        "",
                        "the frame has " + std::to_string(frame.cols) + " x " + std::to_string(frame.rows) +
                            " pixels, expected " + std::to_string(camera.image_size_px.x()) + " x " +
                            std::to_string(camera.image_size_px.y())});
    }
    if (camera.image_size_px.minCoeff() < kLeastSidePx) {
      faults.push_back({name, {}, "", "expected an image of at least 16 pixels each way"});
    }
    if (!normalised(camera.ray_from_ground)) {
      faults.push_back(
          {name, {}, "", "the perspective matrix is singular, expected one that shows the ground"});
    }
  }
  if (!(task.start.sigma().minCoeff() > 0)) {
    faults.push_back({"uncertainty", {}, "", "rotation, position and stretch must all be above 0"});
  }
  if (!(task.view.metres_per_px > 0)) {
    faults.push_back({"view", {}, "", "metres per pixel must be above 0"});
  }
  if (task.folds < 2) faults.push_back({"folds", {}, "", "expected at least 2"});
  return faults;
}

Knowledge first_knowledge(const AlignmentTask& task) {
  Knowledge knowledge;
  knowledge.cameras = task.cameras;
  knowledge.vehicle = task.vehicle;
  knowledge.view = task.view;
  for (size_t i = 0; i < 4; ++i) {
    knowledge.frames[i] = pyramid(task.frames[i]);
    knowledge.starts[i] = *normalised(task.cameras[i].ray_from_ground);
    knowledge.cameras[i].ray_from_ground = knowledge.starts[i];
    knowledge.steps[i].setZero();
  }
  knowledge.covariance = task.start.sigma().cwiseAbs2().replicate<4, 1>().asDiagonal();
  return knowledge;
}

using Features = std::array<OverlapFeatures, 4>;

/// The matches of all overlaps, without those of one fold.
std::vector<RayPair> rays_of(const Features& found, size_t folds, size_t left_out) {
  std::vector<RayPair> pairs;
  for (const auto& overlap : found) {
    for (size_t i = 0; i < overlap.features.size(); ++i) {
      if (i % folds != left_out) pairs.push_back(overlap.features[i].rays);
    }
  }
  return pairs;
}

/// What a feature's noise is by the median of all disagreements (of a Rayleigh distribution).
double measured_noise_m(const std::vector<RayPair>& pairs, const Knowledge& knowledge) {
  constexpr double kMedianToSigma = 1 / 1.1774;
  const DisagreementMeter meter(knowledge.starts, knowledge.steps);
  std::vector<double> apart;
  for (const auto& pair : pairs) apart.push_back(meter.metres(pair).norm());
  if (apart.empty()) return 0;
  std::nth_element(apart.begin(), apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2), apart.end());
  return kMedianToSigma * apart[apart.size() / 2];
}

void fit(const AlignmentTask& task, const std::vector<RayPair>& pairs, double noise_m, Knowledge& knowledge) {
  const JointFit fitted = fit_jointly(knowledge.starts, task.start.sigma(), knowledge.steps, pairs, noise_m);
  knowledge.steps = fitted.steps;
  knowledge.covariance = fitted.covariance;
  for (size_t i = 0; i < 4; ++i) {
    knowledge.cameras[i].ray_from_ground = stepped(knowledge.starts[i], knowledge.steps[i]);
  }
}

std::array<OverlapAlignment, 4> measured(const AlignmentTask& task, const Features& found, double noise_m,
                                         const Knowledge& knowledge) {
  const DisagreementMeter meter(knowledge.starts, knowledge.steps);
  std::vector<DisagreementMeter> without;
  for (size_t fold = 0; fold < task.folds; ++fold) {
    const auto pairs = rays_of(found, task.folds, fold);
    without.emplace_back(
        knowledge.starts,
        fit_jointly(knowledge.starts, task.start.sigma(), knowledge.steps, pairs, noise_m).steps);
  }
  std::array<OverlapAlignment, 4> overlaps;
  for (size_t a = 0; a < 4; ++a) {
    overlaps[a] = {a, next_clockwise(a), {}};
    for (size_t i = 0; i < found[a].features.size(); ++i) {
      const Feature& feature = found[a].features[i];
      const Eigen::Vector2d apart = meter.metres(feature.rays);
      Match match{feature.pixel_a, feature.pixel_b, meter.ground_a(feature.rays) + apart / 2};
      match.residual_px = apart.norm() / task.view.metres_per_px;
      match.held_out_px = without[i % task.folds].metres(feature.rays).norm() / task.view.metres_per_px;
      match.inlier = match.held_out_px < kRejectPx;
      overlaps[a].matches.push_back(match);
    }
  }
  return overlaps;
}

Faults sparse_overlaps(const std::array<OverlapAlignment, 4>& overlaps, const Features& found) {
  Faults faults;
  for (size_t a = 0; a < 4; ++a) {
    const size_t count = overlaps[a].inliers();
    if (count >= kFewestMatches) continue;
    const std::string& name = geometry::kCameraNames[a];
    const std::string& next = geometry::kCameraNames[overlaps[a].b];
    faults.push_back({"overlap " + name + "-" + next,
                      {},
                      "",
                      std::to_string(count) + " features agree, expected at least " +
                          std::to_string(kFewestMatches) +
                          " (corners: " + std::to_string(found[a].corners_a) + " in " + name + ", " +
                          std::to_string(found[a].corners_b) + " in " + next +
                          "; alike: " + std::to_string(found[a].candidates) + ")"});
  }
  return faults;
}

/// An alignment with what was found on the way to it.
struct Attempt {
  Alignment alignment;
  Features found;
};

Attempt attempt(const AlignmentTask& task) {
  StageClock clock;
  Knowledge knowledge = first_knowledge(task);
  clock.spent_on("warp");
  Attempt made;
  double noise_m = 0;
  for (Fineness pass : kPasses) {
    pass.metres_per_px *= task.view.metres_per_px;
    for (size_t a = 0; a < 4; ++a) made.found[a] = match_overlap(knowledge, a, pass, clock);
    const auto pairs = rays_of(made.found, task.folds, task.folds);
    fit(task, pairs, kNoisePx * pass.metres_per_px, knowledge);
    if (pass.patches) {
      noise_m = std::max(kLeastNoisePx * task.view.metres_per_px, measured_noise_m(pairs, knowledge));
      fit(task, pairs, noise_m, knowledge);
    }
    clock.spent_on("fit");
  }
  for (size_t i = 0; i < 4; ++i) made.alignment.ray_from_ground[i] = knowledge.cameras[i].ray_from_ground;
  made.alignment.overlaps = measured(task, made.found, noise_m, knowledge);
  clock.spent_on("hold out");
  made.alignment.times = clock.times();
  return made;
}

double rms_of_inliers(const std::vector<Match>& matches, double Match::*residual_px) {
  double squares = 0;
  int count = 0;
  for (const auto& match : matches) {
    if (!match.inlier) continue;
    squares += match.*residual_px * match.*residual_px;
    ++count;
  }
  return count ? std::sqrt(squares / count) : 0;
}

}  // namespace

size_t OverlapAlignment::inliers() const {
  return static_cast<size_t>(
      std::count_if(matches.begin(), matches.end(), [](const Match& match) { return match.inlier; }));
}

double OverlapAlignment::residual_rms_px() const {
  return rms_of_inliers(matches, &Match::residual_px);
}

double OverlapAlignment::held_out_rms_px() const {
  return rms_of_inliers(matches, &Match::held_out_px);
}

Result<Alignment> align(const AlignmentTask& task) {
  if (Faults faults = faults_of(task); !faults.empty()) return tl::unexpected(faults);
  Attempt made = attempt(task);
  if (Faults faults = sparse_overlaps(made.alignment.overlaps, made.found); !faults.empty())
    return tl::unexpected(faults);
  return std::move(made.alignment);
}

Result<Alignment> align_by_any_matches(const AlignmentTask& task) {
  if (Faults faults = faults_of(task); !faults.empty()) return tl::unexpected(faults);
  return attempt(task).alignment;
}

}  // namespace svchain::registration
