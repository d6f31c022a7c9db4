#include "links/capture/render_ahead.h"

namespace svchain {

RenderAhead::RenderAhead(cv::Size size_px, Render render)
    : render_(std::move(render)), picture_(size_px, CV_8UC3) {}

void RenderAhead::start() {
  made_ = kNone;
  wanted_ = 0;
  thread_ = std::thread([this] { work(); });
}

void RenderAhead::work() {
  while (true) {
    const uint64_t wanted = wanted_.load();
    if (wanted == kQuit) return;
    if (wanted == made_.load()) {
      wanted_.wait(wanted);
      continue;
    }
    render_(wanted, picture_);
    made_.store(wanted);
    made_.notify_one();
  }
}

void RenderAhead::read(uint64_t set, cv::Mat& into) {
  // Sets that were dropped for being late were perhaps begun: that one is let finish, then this one is made.
  if (wanted_.exchange(set) != set) wanted_.notify_one();
  for (uint64_t made = made_.load(); made != set; made = made_.load()) made_.wait(made);
  picture_.copyTo(into);
  wanted_.store(set + 1);
  wanted_.notify_one();
}

void RenderAhead::stop() {
  if (!thread_.joinable()) return;
  wanted_.store(kQuit);
  wanted_.notify_one();
  thread_.join();
}

}  // namespace svchain
