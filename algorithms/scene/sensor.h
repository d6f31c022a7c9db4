#pragma once
// From light to grey levels: a camera's gains, gamma and noise. Immutable; any thread; develop() allocates
// nothing.

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// The curve by itself, without falloff and noise: 0..255 to 0..255.
double respond(const Response& response, int channel, double light);

/// B, G, R (0..255, clamped) as Sensor::develop takes them.
uint64_t packed_light(const Eigen::Vector3d& bgr);

class Sensor {
 public:
  Sensor(const Response& response, uint64_t seed);

  static constexpr int kMostPixels = 256;  // at a time

  /// Turns light (B, G, R from the low 16 bits up, each 8.8 fixed point up to 255.0) with the falloff of each
  /// pixel (16-bit fraction) into grey levels. `noise_key` picks the noise: the same key, the same noise.
  void develop(const uint64_t* light, const uint16_t* falloff, int pixels, uint64_t noise_key,
               uint8_t* bgr) const;

 private:
  std::array<std::array<int16_t, 1024>, 3>
      curve_;                   // of light in quarters of a level, to sixteenths of a level
  std::vector<int16_t> noise_;  // sixteenths of a level
};

}  // namespace svchain::scene
