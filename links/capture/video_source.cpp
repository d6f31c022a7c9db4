#include "links/capture/video_source.h"

#include <cmath>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "algorithms/geometry/rig.h"
#include "links/capture/open_video.h"

namespace svchain {

namespace fs = std::filesystem;

namespace {

struct Video {
  fs::path path;
  cv::VideoCapture capture;
  uint64_t next = 0;  // frame that the next grab gives
};

cv::Size size_of(const cv::VideoCapture& capture) {
  return {static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH)),
          static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT))};
}

/// Nothing where the container does not say.
std::optional<uint64_t> length_of(const cv::VideoCapture& capture) {
  const double frames = capture.get(cv::CAP_PROP_FRAME_COUNT);
  if (!(frames >= 1) || frames > 1e12) return std::nullopt;
  return static_cast<uint64_t>(std::llround(frames));
}

class VideoSource final : public FrameSource {
 public:
  VideoSource(std::array<Video, kCameras> videos, double fps) : fps_(fps), videos_(std::move(videos)) {
    for (size_t c = 0; c < kCameras; ++c) facts_.size_px[c] = size_of(videos_[c].capture);
    facts_.sets = facts_.usual_sets = length_of(videos_[0].capture);
  }

  const SourceFacts& facts() const override { return facts_; }
  bool ended() const override { return ended_; }

  std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) override {
    Video& video = videos_[camera];
    cv::Mat image = into;
    bool there = true;
    for (; there && video.next <= set; ++video.next) there = video.capture.grab();
    if (!there || !video.capture.retrieve(image) || image.empty()) return end_of(camera, set);
    if (image.size() != into.size() || image.type() != into.type()) {
      throw std::runtime_error(where(camera, set) + "is " + std::to_string(image.cols) + "x" +
                               std::to_string(image.rows) + " px, expected " + std::to_string(into.cols) +
                               "x" + std::to_string(into.rows));
    }
    if (image.data != into.data) image.copyTo(into);
    return nominal_time_ns(set, fps_);
  }
  int64_t time_ns(uint64_t set, size_t) const override { return nominal_time_ns(set, fps_); }

 private:
  std::optional<int64_t> end_of(size_t camera, uint64_t set) {
    if (facts_.sets) {
      throw std::runtime_error(where(camera, set) + "ends here, its container promises " +
                               std::to_string(*facts_.sets) + " frames");
    }
    ended_ = true;
    return std::nullopt;
  }
  std::string where(size_t camera, uint64_t set) const {
    return geometry::kCameraNames[camera] + " frame " + std::to_string(set) + ": " +
           videos_[camera].path.string() + " ";
  }

  double fps_;
  std::array<Video, kCameras> videos_;
  SourceFacts facts_;
  bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_videos(const SourceFolder& folder, const SourceRequest& request) {
  std::array<Video, kCameras> videos;
  Faults faults;
  for (size_t c = 0; c < kCameras; ++c) {
    videos[c].path = folder.paths[c];
    const std::string file = folder.paths[c].string();
    if (!open_video(videos[c].capture, file) || size_of(videos[c].capture).empty()) {
      faults.push_back({file, {}, "", "cannot be opened as a video"});
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  const auto front = length_of(videos[0].capture);
  for (size_t c = 1; c < kCameras; ++c) {
    const auto length = length_of(videos[c].capture);
    if (front && length && *length != *front) {
      faults.push_back({folder.paths[c].string(),
                        {},
                        "",
                        geometry::kCameraNames[c] + " has " + std::to_string(*length) +
                            " frames, front has " + std::to_string(*front)});
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return std::make_unique<VideoSource>(std::move(videos), request.fps);
}

std::optional<double> video_fps(const SourceFolder& folder) {
  cv::VideoCapture capture;
  open_video(capture, folder.paths[0].string());
  if (!capture.isOpened()) return std::nullopt;
  const double fps = capture.get(cv::CAP_PROP_FPS);
  return fps > 0 && std::isfinite(fps) ? std::optional(fps) : std::nullopt;
}

}  // namespace svchain
