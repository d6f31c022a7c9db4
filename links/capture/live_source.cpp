#include "links/capture/live_source.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <mutex>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <thread>

#include "algorithms/geometry/rig.h"
#include "links/capture/open_video.h"

namespace svchain {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTimeoutMs = 5000;  // network streams: for opening, and for a frame

bool open(cv::VideoCapture& capture, const std::string& url) {
  const bool number = !url.empty() && url.size() < 4 &&
                      std::all_of(url.begin(), url.end(), [](unsigned char c) { return std::isdigit(c); });
  if (number) return capture.open(std::stoi(url));
  return capture.open(
             url, cv::CAP_FFMPEG,
             {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kTimeoutMs, cv::CAP_PROP_READ_TIMEOUT_MSEC, kTimeoutMs}) ||
         open_video(capture, url);
}

class LiveCamera {
 public:
  ~LiveCamera() { stop(); }

  bool open(const std::string& url) { return svchain::open(capture_, url); }
  cv::Size size() const {
    return {static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_WIDTH)),
            static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_HEIGHT))};
  }

  void start(Clock::time_point zero) {
    thread_ = std::thread([this, zero] { keep_newest(zero); });
  }
  void stop() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }

  /// The frame that came since the last one was fetched, valid until the next fetch.
  std::optional<int64_t> fetch(cv::Mat& image) {
    const std::lock_guard lock(mutex_);
    if (!fresh_) return std::nullopt;
    fresh_ = false;
    cv::swap(newest_, fetched_);
    image = fetched_;
    return newest_ns_;
  }
  bool ended() const {
    const std::lock_guard lock(mutex_);
    return ended_ && !fresh_;
  }

 private:
  void keep_newest(Clock::time_point zero) {
    cv::Mat image;
    while (!stopping_ && capture_.read(image)) {
      const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - zero);
      const std::lock_guard lock(mutex_);  // held for an exchange only
      cv::swap(newest_, image);
      newest_ns_ = now.count();
      fresh_ = true;
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }

  cv::VideoCapture capture_;  // the thread's own once it runs
  std::thread thread_;
  std::atomic<bool> stopping_{false};
  mutable std::mutex mutex_;  // what follows
  cv::Mat newest_, fetched_;
  int64_t newest_ns_ = 0;
  bool fresh_ = false;
  bool ended_ = false;
};

class LiveSource final : public FrameSource {
 public:
  LiveSource() { facts_.live = true; }

  bool open_camera(size_t camera, const std::string& url) {
    if (!cameras_[camera].open(url)) return false;
    facts_.size_px[camera] = cameras_[camera].size();
    return !facts_.size_px[camera].empty();
  }

  const SourceFacts& facts() const override { return facts_; }
  void start() override {
    const auto zero = Clock::now();
    for (LiveCamera& camera : cameras_) camera.start(zero);
  }
  void stop() override {
    for (LiveCamera& camera : cameras_) camera.stop();
  }

  std::optional<int64_t> read(uint64_t set, size_t camera, cv::Mat& into) override {
    cv::Mat image;
    const auto time_ns = cameras_[camera].fetch(image);
    if (!time_ns) return std::nullopt;
    if (image.size() != into.size() || image.type() != into.type()) {
      throw std::runtime_error(geometry::kCameraNames[camera] + " frame " + std::to_string(set) + " is " +
                               std::to_string(image.cols) + "x" + std::to_string(image.rows) +
                               " px, expected " + std::to_string(into.cols) + "x" +
                               std::to_string(into.rows));
    }
    image.copyTo(into);
    return time_ns;
  }
  bool ended() const override {
    return std::all_of(cameras_.begin(), cameras_.end(),
                       [](const LiveCamera& camera) { return camera.ended(); });
  }
  int64_t time_ns(uint64_t, size_t) const override { return 0; }  // never asked: it needs a virtual clock

 private:
  SourceFacts facts_;
  std::array<LiveCamera, kCameras> cameras_;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_live(const std::array<std::string, kCameras>& urls) {
  auto source = std::make_unique<LiveSource>();
  Faults faults;
  for (size_t c = 0; c < kCameras; ++c) {
    if (!source->open_camera(c, urls[c])) {
      faults.push_back({geometry::kCameraNames[c] + "=" + urls[c], {}, "", "cannot be opened"});
    }
  }
  if (!faults.empty()) return tl::unexpected(faults);
  return source;
}

}  // namespace svchain
