#include "usecases/svchain_accuracy/photometric_sequences.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "algorithms/photometric/block_means.h"
#include "algorithms/photometric/photometric_alignment.h"
#include "algorithms/scene/renderer.h"
#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_accuracy/photometric_set.h"

namespace svchain::accuracy {

namespace {

using synthesis::OverlapStatistics;
using synthesis::ToneMapping;

/// Frame after frame through synthesis and photometric alignment, each frame with the last one's curves.
class Loop {
 public:
  explicit Loop(const scene::Scene& scene)
      : view_(photometric_view(scene.rig.vehicle)),
        lut_memory_(synthesis::geometric_lut_capacity(view_, 4)),
        statistics_memory_(OverlapStatistics::bytes_for(view_)),
        statistics_(OverlapStatistics::create(statistics_memory_)),
        alignment_({.most_blocks = statistics_->capacity}),
        composite_(view_.size_px.y(), view_.size_px.x(), CV_8UC3),
        frames_(4) {
    synthesis::build_geometric_lut(scene.rig, view_, {}, lut_memory_);
  }

  void run(const scene::Renderer& renderer, uint64_t frame) {
    for (size_t camera = 0; camera < 4; ++camera) renderer.render(camera, 0, frame, frames_[camera]);
    synthesis::synthesize(lut(), frames_, alignment_.tone_mapping(), composite_, statistics_);
    used_ = alignment_.tone_mapping();
    alignment_.update(*statistics_);
  }

  const ToneMapping& next() const { return alignment_.tone_mapping(); }
  double composite_mean() const {
    const cv::Scalar mean = cv::mean(composite_);
    return (mean[0] + mean[1] + mean[2]) / 3;
  }
  /// In the overlaps of the last composite.
  double difference() const {
    double sum = 0;
    const auto means = photometric::block_means(lut(), frames_, used_);
    for (const auto& block : means) sum += block.difference();
    return sum / static_cast<double>(means.size());
  }

 private:
  synthesis::GeometricLut lut() const { return synthesis::GeometricLut(lut_memory_); }

  geometry::View view_;
  std::vector<std::byte> lut_memory_, statistics_memory_;
  OverlapStatistics* statistics_;
  photometric::PhotometricAlignment alignment_;
  cv::Mat composite_;
  std::vector<cv::Mat> frames_;
  ToneMapping used_ = ToneMapping::identity();
};

std::shared_ptr<const scene::World> world_of(scene::Scene scene) {
  return std::make_shared<const scene::World>(std::move(scene));
}

double largest_change(const ToneMapping& a, const ToneMapping& b) {
  int largest = 0;
  for (size_t i = 0; i < 4; ++i)
    for (size_t c = 0; c < 3; ++c)
      for (size_t v = 0; v < 256; ++v)
        largest = std::max(largest, std::abs(a.curves[i][c][v] - b.curves[i][c][v]));
  return largest;
}

}  // namespace

ExposureStep measure_exposure_step() {
  constexpr int kBefore = 10, kAfter = 60;
  scene::Scene scene = photometric_scene(kUnlikeCameras, 1);
  const scene::Renderer before(world_of(scene));
  for (double& gain : scene.responses[1].gain_bgr) gain *= std::exp2(-1.5);
  const scene::Renderer after(world_of(scene));

  Loop loop(scene);
  uint64_t frame = 0;
  while (frame < kBefore) loop.run(before, frame++);
  const double settled = loop.difference() + 1;
  ExposureStep step;
  double last_mean = 0;
  for (int i = 0; i < kAfter; ++i) {
    loop.run(after, frame++);
    if (loop.difference() > settled) step.frames_to_settle = i + 1;
    const double mean = loop.composite_mean();
    if (i >= 15) step.largest_move = std::max(step.largest_move, std::abs(mean - last_mean));
    last_mean = mean;
  }
  return step;
}

double measure_crossing() {
  constexpr int kBefore = 10, kSteps = 40, kFramesPerStep = 2;
  scene::Scene scene = photometric_scene(kUnlikeCameras, 1);
  const scene::Renderer empty(world_of(scene));
  Loop loop(scene);
  uint64_t frame = 0;
  while (frame < kBefore) loop.run(empty, frame++);
  const ToneMapping before = loop.next();
  double largest = 0;
  for (int i = 0; i < kSteps; ++i) {  // across the overlap of the front and right cameras, a metre a second
    scene.posts = {{{3.4, -3.2 + i * 0.067}, 0.25, 1.75, {60, 40, 30}}};
    const scene::Renderer crossed(world_of(scene));
    for (int n = 0; n < kFramesPerStep; ++n) {
      loop.run(crossed, frame++);
      largest = std::max(largest, largest_change(loop.next(), before));
    }
  }
  return largest;
}

double measure_equal_cameras() {
  ResponseRange equal = {"equal", {1, 1}, {1, 1}, {0, 0}, {0, 0}};
  const scene::Scene scene = photometric_scene(equal, 1);
  const scene::Renderer renderer(world_of(scene));
  Loop loop(scene);
  double largest = 0;
  for (uint64_t frame = 0; frame < 10; ++frame) {
    loop.run(renderer, frame);
    largest = std::max(largest, largest_change(loop.next(), ToneMapping::identity()));
  }
  return largest;
}

}  // namespace svchain::accuracy
