#pragma once
// Simulated cameras for real time: each has a thread of its own that makes its next picture while the chain
// works on the last one, as a real camera exposes while nobody waits for it. Same pictures as without.
// start(), read() and stop() belong to the capture's core.

#include <atomic>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <thread>

namespace svchain {

class RenderAhead {
 public:
  using Render = std::function<void(uint64_t set, cv::Mat& into)>;

  RenderAhead(cv::Size size_px, Render render);
  ~RenderAhead() { stop(); }
  RenderAhead(const RenderAhead&) = delete;
  RenderAhead& operator=(const RenderAhead&) = delete;

  void start();
  /// Copies the picture of a set, waiting for it where it is not made yet, and lets the next one be made.
  void read(uint64_t set, cv::Mat& into);
  void stop();

 private:
  static constexpr uint64_t kNone = ~uint64_t{0};
  static constexpr uint64_t kQuit = kNone - 1;
  void work();

  Render render_;
  cv::Mat picture_;  // the thread's while made_ != wanted_, the reader's otherwise
  std::atomic<uint64_t> wanted_{kNone};
  std::atomic<uint64_t> made_{kNone};
  std::thread thread_;
};

}  // namespace svchain
