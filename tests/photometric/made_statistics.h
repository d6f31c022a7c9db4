#pragma once
// Overlap statistics as cameras of known gains would give them.

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "algorithms/synthesis/overlap_statistics.h"

namespace svchain::testing {

/// What a camera makes of brightness, per channel: the gain that would undo it is the inverse.
using Response = std::array<double, 3>;

class MadeStatistics {
 public:
  explicit MadeStatistics(size_t capacity = 1000)
      : memory_(sizeof(synthesis::OverlapStatistics) + capacity * sizeof(synthesis::OverlapBlock)),
        statistics_(synthesis::OverlapStatistics::create(memory_)) {}

  /// A block of the two cameras on ground of this brightness, seen with `noise` (relative).
  void add(int a, int b, const std::array<double, 3>& ground, const Response& of_a, const Response& of_b,
           double noise = 0, uint32_t pixels = 1600) {
    synthesis::OverlapBlock block{};
    block.camera_a = static_cast<uint16_t>(a);
    block.camera_b = static_cast<uint16_t>(b);
    block.pixels = pixels;
    std::normal_distribution<double> normal(1, noise);
    for (int c = 0; c < 3; ++c) {
      block.a.sum[c] = static_cast<uint32_t>(std::lround(pixels * ground[c] * of_a[c] * normal(random_)));
      block.b.sum[c] = static_cast<uint32_t>(std::lround(pixels * ground[c] * of_b[c] * normal(random_)));
    }
    statistics_->add(block);
  }

  /// Ground that is not too bright for any of the cameras.
  std::array<double, 3> some_ground() {
    std::uniform_real_distribution<double> brightness(40, 150);
    return {brightness(random_), brightness(random_), brightness(random_)};
  }

  synthesis::OverlapStatistics& operator*() { return *statistics_; }

 private:
  std::mt19937 random_{3};
  std::vector<std::byte> memory_;
  synthesis::OverlapStatistics* statistics_;
};

/// Four cameras with four overlaps of 40 blocks each.
inline MadeStatistics ring_of_four(const std::array<Response, 4>& responses, double noise = 0) {
  MadeStatistics statistics;
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 40; ++i)
      statistics.add(a, (a + 1) % 4, statistics.some_ground(), responses[a], responses[(a + 1) % 4], noise);
  return statistics;
}

inline constexpr std::array<Response, 4> kFourResponses = {
    Response{1.1, 0.9, 1.0}, {0.8, 1.0, 1.2}, {1.3, 1.2, 0.9}, {0.9, 0.85, 0.95}};

}  // namespace svchain::testing
