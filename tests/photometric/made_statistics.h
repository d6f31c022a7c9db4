#pragma once
// Overlap statistics as cameras of known responses would give them.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "algorithms/synthesis/overlap_statistics.h"

namespace svchain::testing {

/// What a camera makes of light: 255 (gain light / 255 / (1 + falloff q^2))^gamma.
struct MadeCamera {
  std::array<double, 3> gain = {1, 1, 1};
  double gamma = 1;
  double falloff = 0;

  double value(double light, int channel, double q2) const {
    const double exposed = gain[channel] * light / 255 / (1 + falloff * q2);
    return std::clamp(255 * std::pow(exposed, gamma), 0.0, 255.0);
  }
};
using FourCameras = std::array<MadeCamera, 4>;

/// A piece of ground that two cameras see: 64 places between the light of its darkest and of its brightest.
struct MadeGround {
  std::array<double, 3> light = {100, 100, 100};
  double contrast = 0.2;  // of the darkest and brightest to the mean
};

class MadeStatistics {
 public:
  explicit MadeStatistics(size_t capacity = 1000)
      : memory_(sizeof(synthesis::OverlapStatistics) + capacity * sizeof(synthesis::OverlapBlock)),
        statistics_(synthesis::OverlapStatistics::create(memory_)) {}

  /// A block of 1600 px. `noise` is how far (relative) the two see the same ground differently.
  synthesis::OverlapBlock& add(int a, int b, const MadeGround& ground, const MadeCamera& of_a,
                               const MadeCamera& of_b, double noise = 0) {
    synthesis::OverlapBlock block{};
    block.camera_a = static_cast<uint16_t>(a);
    block.camera_b = static_cast<uint16_t>(b);
    block.pixels = 1600;
    std::uniform_real_distribution<float> anywhere(0.1f, 0.9f);
    block.q2_a = anywhere(random_);
    block.q2_b = anywhere(random_);
    see(ground, of_a, block.q2_a, noise, block.a);
    see(ground, of_b, block.q2_b, noise, block.b);
    statistics_->add(block);
    return const_cast<synthesis::OverlapBlock&>(statistics_->blocks().back());
  }

  MadeGround some_ground(double darkest = 30, double brightest = 190) {
    std::uniform_real_distribution<double> light(darkest, brightest), contrast(0, 0.4);
    const double grey = light(random_);
    std::uniform_real_distribution<double> tint(0.85, 1.15);
    return {{grey * tint(random_), grey * tint(random_), grey * tint(random_)}, contrast(random_)};
  }

  synthesis::OverlapStatistics& operator*() { return *statistics_; }

 private:
  void see(const MadeGround& ground, const MadeCamera& camera, double q2, double noise,
           synthesis::BlockSamples& samples) {
    std::normal_distribution<double> relative(1, noise);
    constexpr int kPlaces = 64, kPixelsPerPlace = 25;
    const double differs = noise > 0 ? relative(random_) : 1;
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < kPlaces; ++i) {
        const double light =
            differs * ground.light[c] * (1 + ground.contrast * (2.0 * i / (kPlaces - 1) - 1));
        const auto value = static_cast<uint32_t>(std::lround(camera.value(light, c, q2)));
        samples.sum[c] += kPixelsPerPlace * value;
        samples.sum_of_squares[c] += kPixelsPerPlace * value * value;
        samples.clipped[c] += value <= 2 || value >= 253 ? kPixelsPerPlace : 0;
      }
  }

  std::mt19937 random_{3};
  std::vector<std::byte> memory_;
  synthesis::OverlapStatistics* statistics_;
};

/// Four cameras with four overlaps of 40 blocks each.
inline MadeStatistics ring_of_four(const FourCameras& cameras, double noise = 0) {
  MadeStatistics statistics;
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 40; ++i)
      statistics.add(a, (a + 1) % 4, statistics.some_ground(), cameras[a], cameras[(a + 1) % 4], noise);
  return statistics;
}

inline const FourCameras kEqualCameras = {};
inline const FourCameras kUnlikeGains = {
    MadeCamera{{1.1, 0.9, 1.0}}, {{0.8, 1.0, 1.2}}, {{1.25, 1.2, 0.9}}, {{0.9, 0.85, 0.95}}};
inline const FourCameras kUnlikeGammas = {MadeCamera{{1.1, 0.9, 1.0}, 0.9},
                                          {{0.8, 1.0, 1.2}, 1.0},
                                          {{1.25, 1.2, 0.9}, 1.1},
                                          {{0.9, 0.85, 0.95}, 0.95}};

}  // namespace svchain::testing
