#pragma once
// The chain's time in nanoseconds from its own zero. Steady: the machine's monotonic clock. Virtual: stands
// still until it is moved, so that a run is a function of its inputs. Any thread may read; a virtual clock is
// moved by its one executor.

#include <atomic>
#include <chrono>
#include <cstdint>

namespace svchain {

class Clock {
 public:
  virtual ~Clock() = default;
  virtual int64_t now_ns() const = 0;
};

class SteadyClock final : public Clock {
 public:
  int64_t now_ns() const override {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - zero_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point zero_ = std::chrono::steady_clock::now();
};

class VirtualClock final : public Clock {
 public:
  int64_t now_ns() const override { return now_ns_.load(std::memory_order_relaxed); }
  /// Time never runs backwards: an earlier time is ignored.
  void advance_to(int64_t time_ns) {
    if (time_ns > now_ns()) now_ns_.store(time_ns, std::memory_order_relaxed);
  }

 private:
  std::atomic<int64_t> now_ns_{0};
};

}  // namespace svchain
