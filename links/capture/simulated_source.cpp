#include "links/capture/simulated_source.h"

#include <filesystem>

#include "algorithms/scene/motion.h"
#include "algorithms/scene/renderer.h"
#include "algorithms/scene/scene_file.h"
#include "links/capture/render_ahead.h"
#include "links/configs_folder.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

class SimulatedSource final : public FrameSource {
 public:
  SimulatedSource(scene::Scene scene, const SourceRequest& request) : scene_(std::move(scene)) {
    if (request.pixels) renderer_.emplace(std::make_shared<scene::World>(scene_));
    facts_.usual_sets = 300;
    for (size_t c = 0; c < kCameras; ++c) {
      const Eigen::Vector2i size = scene_.rig.cameras[c].image_size_px;
      facts_.size_px[c] = {size.x(), size.y()};
      if (!request.real_time) continue;
      ahead_[c] = std::make_unique<RenderAhead>(
          facts_.size_px[c], [this, c](uint64_t set, cv::Mat& into) { render(set, c, into); });
    }
  }

  const SourceFacts& facts() const override { return facts_; }
  std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) override {
    if (ahead_[camera]) {
      ahead_[camera]->read(set, into);
    } else {
      render(set, camera, into);
    }
    return time_ns(set, camera);
  }
  int64_t time_ns(uint64_t set, size_t camera) const override {
    return scene::capture_time_ns(scene_, camera, set);
  }
  void start() override {
    for (auto& camera : ahead_) {
      if (camera) camera->start();
    }
  }
  void stop() override {
    for (auto& camera : ahead_) {
      if (camera) camera->stop();
    }
  }

 private:
  void render(uint64_t set, size_t camera, cv::Mat& into) const {
    renderer_->render(camera, static_cast<double>(time_ns(set, camera)) * 1e-9, set, into);
  }

  const scene::Scene scene_;
  std::optional<scene::Renderer> renderer_;  // none where no pixels are asked for
  SourceFacts facts_;
  std::array<std::unique_ptr<RenderAhead>, kCameras> ahead_;  // in real time only
};

}  // namespace

Result<fs::path> find_scene(const std::string& scene) {
  auto found = find_config("scenes", "scene", scene);
  if (!found) found.error().front().file = "simulated:" + scene;
  return found;
}

Result<std::unique_ptr<FrameSource>> open_simulated(const std::string& scene, const SourceRequest& request) {
  const auto path = find_scene(scene);
  if (!path) return tl::unexpected(path.error());
  auto read = scene::read_scene(*path);
  if (!read) return tl::unexpected(read.error());
  read->frame_rate_hz = request.fps;
  read->seed += request.seed - 1;  // 1, the usual one, leaves the scene's own
  return std::make_unique<SimulatedSource>(std::move(*read), request);
}

}  // namespace svchain
