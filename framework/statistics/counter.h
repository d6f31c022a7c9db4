#pragma once
// Counters and histograms that one thread writes and any may read: relaxed single-writer stores, no
// read-modify-write, no allocation after construction.

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace svchain {

class Counter {
 public:
  void add(uint64_t n = 1) { value_.store(value() + n, std::memory_order_relaxed); }
  uint64_t value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<uint64_t> value_{0};
};

/// Durations in nanoseconds, 16 steps to every doubling: quantiles are right to 6 %, the maximum exactly.
class Histogram {
 public:
  void record(int64_t ns) {
    const uint64_t v = ns > 0 ? static_cast<uint64_t>(ns) : 0;
    buckets_[bucket_of(v)].add();
    count_.add();
    if (v > max_.load(std::memory_order_relaxed)) max_.store(v, std::memory_order_relaxed);
  }
  uint64_t count() const { return count_.value(); }
  int64_t max_ns() const { return static_cast<int64_t>(max_.load(std::memory_order_relaxed)); }
  /// Upper edge of the bucket that holds the quantile, never above the maximum.
  int64_t quantile_ns(double q) const;

 private:
  static constexpr int kSteps = 16;
  static constexpr size_t kBuckets = 61 * kSteps;

  static size_t bucket_of(uint64_t v) {
    if (v < kSteps) return static_cast<size_t>(v);
    const int exponent = static_cast<int>(std::bit_width(v)) - 5;  // v >> exponent lies in 16..31
    return static_cast<size_t>(exponent) * kSteps + static_cast<size_t>(v >> exponent);
  }
  static uint64_t upper_edge(size_t bucket) {
    if (bucket < 2 * kSteps) return bucket;
    const size_t exponent = bucket / kSteps - 1;
    return ((kSteps + bucket % kSteps + 1) << exponent) - 1;
  }

  std::array<Counter, kBuckets> buckets_;
  Counter count_;
  std::atomic<uint64_t> max_{0};
};

}  // namespace svchain
