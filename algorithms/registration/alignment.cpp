#include "algorithms/registration/alignment.h"

#include <cmath>

#include "algorithms/registration/overlap.h"
#include "algorithms/registration/overlap_match.h"

namespace svchain::registration {

namespace {

constexpr size_t kFewestMatches = 8;
constexpr double kNoisePx = 1;  // of a feature on the ground, at the scale it is found at
constexpr double kRejectPx = 5;  // of the view: farther apart no true match is
constexpr Fineness kFineness[] = {{4, 3, false}, {2, 2, false}, {2, 2, false}, {1, 1, true}, {1, 1, true}};

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
      faults.push_back({name, {}, "",
                        "the frame has " + std::to_string(frame.cols) + " x " + std::to_string(frame.rows) +
                            " pixels, expected " + std::to_string(camera.image_size_px.x()) + " x " +
                            std::to_string(camera.image_size_px.y())});
    }
    if (!normalised(camera.ray_from_ground)) {
      faults.push_back({name, {}, "", "the perspective matrix is singular, expected one that shows the ground"});
    }
  }
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

bool held_out(const AlignmentTask& task, size_t match) {
  return task.hold_out && match % 2 == 1;
}

void fit(const AlignmentTask& task, const Features& found, double noise_m, Knowledge& knowledge) {
  std::vector<RayPair> pairs;
  for (const auto& overlap : found) {
    for (size_t i = 0; i < overlap.features.size(); ++i) {
      if (!held_out(task, i)) pairs.push_back(overlap.features[i].rays);
    }
  }
  const JointFit fitted = fit_jointly(knowledge.starts, task.start.sigma(), knowledge.steps, pairs, noise_m);
  knowledge.steps = fitted.steps;
  knowledge.covariance = fitted.covariance;
  for (size_t i = 0; i < 4; ++i) {
    knowledge.cameras[i].ray_from_ground = stepped(knowledge.starts[i], knowledge.steps[i]);
  }
}

std::array<OverlapAlignment, 4> measured(const AlignmentTask& task, const Features& found,
                                         const Knowledge& knowledge) {
  const DisagreementMeter meter(knowledge.starts, knowledge.steps);
  std::array<OverlapAlignment, 4> overlaps;
  for (size_t a = 0; a < 4; ++a) {
    overlaps[a].a = a;
    overlaps[a].b = next_clockwise(a);
    for (const auto& feature : found[a].features) {
      const Eigen::Vector2d apart = meter.metres(feature.rays);
      Match match{feature.pixel_a, feature.pixel_b, meter.ground_a(feature.rays) + apart / 2};
      match.residual_px = apart.norm() / task.view.metres_per_px;
      match.inlier = match.residual_px < kRejectPx;
      match.held_out = held_out(task, overlaps[a].matches.size());
      overlaps[a].matches.push_back(match);
    }
  }
  return overlaps;
}

Faults sparse_overlaps(const Features& found) {
  Faults faults;
  for (size_t a = 0; a < 4; ++a) {
    const size_t count = found[a].features.size();
    if (count >= kFewestMatches) continue;
    faults.push_back({geometry::kCameraNames[a] + "-" + geometry::kCameraNames[next_clockwise(a)], {}, "",
                      std::to_string(count) + " features match in the overlap, expected at least " +
                          std::to_string(kFewestMatches) + " (corners: " +
                          std::to_string(found[a].corners_a) + " and " + std::to_string(found[a].corners_b) +
                          ", candidates: " + std::to_string(found[a].candidates) + ")"});
  }
  return faults;
}

}  // namespace

double OverlapAlignment::rms_px(bool held_out) const {
  double squares = 0;
  int count = 0;
  for (const auto& match : matches) {
    if (!match.inlier || match.held_out != held_out) continue;
    squares += match.residual_px * match.residual_px;
    ++count;
  }
  return count ? std::sqrt(squares / count) : 0;
}

Result<Alignment> align(const AlignmentTask& task) {
  if (Faults faults = faults_of(task); !faults.empty()) return tl::unexpected(faults);
  StageClock clock;
  Knowledge knowledge = first_knowledge(task);
  clock.spent_on("warp");
  Features found;
  for (Fineness fineness : kFineness) {
    fineness.metres_per_px *= task.view.metres_per_px;
    for (size_t a = 0; a < 4; ++a) found[a] = match_overlap(knowledge, a, fineness, clock);
    fit(task, found, kNoisePx * fineness.metres_per_px, knowledge);
    clock.spent_on("fit");
  }
  if (Faults faults = sparse_overlaps(found); !faults.empty()) return tl::unexpected(faults);
  Alignment alignment;
  for (size_t i = 0; i < 4; ++i) alignment.ray_from_ground[i] = knowledge.cameras[i].ray_from_ground;
  alignment.overlaps = measured(task, found, knowledge);
  alignment.times = clock.times();
  return alignment;
}

}  // namespace svchain::registration
