#include "links/capture/stills_source.h"

#include <stdexcept>

#include "links/capture/image_file.h"

namespace svchain {

namespace {

class StillsSource final : public FrameSource {
 public:
  explicit StillsSource(double fps) : fps_(fps) {
    facts_.still = true;
    facts_.usual_sets = 30;
  }

  void decode(size_t camera, const std::filesystem::path& path) {
    read_image(path, images_[camera]);
    facts_.size_px[camera] = images_[camera].size();
  }

  const SourceFacts& facts() const override { return facts_; }
  std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) override {
    images_[camera].copyTo(into);
    return nominal_time_ns(set, fps_);
  }
  int64_t time_ns(uint64_t set, size_t) const override { return nominal_time_ns(set, fps_); }

 private:
  double fps_;
  SourceFacts facts_;
  std::array<cv::Mat, kCameras> images_;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_stills(const SourceFolder& folder, const SourceRequest& request) {
  auto source = std::make_unique<StillsSource>(request.fps);
  Faults faults;
  for (size_t c = 0; c < kCameras; ++c) {
    try {
      source->decode(c, folder.paths[c]);
    } catch (const std::runtime_error& error) {
      faults.push_back({folder.paths[c].string(), {}, "", error.what()});
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return source;
}

}  // namespace svchain
