#include "algorithms/scene/sensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/scene/hash.h"

namespace svchain::scene {

namespace {
constexpr uint64_t kNoise =
    1 << 16;  // values in the stock of noise, from which pieces are cut at random places
}

double respond(const Response& response, int channel, double light) {
  const double exposed = response.gain_bgr[static_cast<size_t>(channel)] * light / 255;
  return std::min(255.0, 255 * std::pow(exposed, response.gamma));
}

uint64_t packed_light(const Eigen::Vector3d& bgr) {
  uint64_t word = 0;
  for (int c = 0; c < 3; ++c)
    word |= static_cast<uint64_t>(std::lround(std::clamp(bgr[c], 0.0, 255.0) * 256)) << 16 * c;
  return word;
}

Sensor::Sensor(const Response& response, uint64_t seed) : noise_(kNoise + 3 * kMostPixels) {
  for (size_t c = 0; c < 3; ++c) {
    for (size_t i = 0; i < curve_[c].size(); ++i) {
      const double level = respond(response, static_cast<int>(c), static_cast<double>(i) / 4);
      curve_[c][i] = static_cast<int16_t>(std::lround(16 * level));
    }
  }
  for (size_t i = 0; i < noise_.size(); ++i) {  // Box & Muller 1958
    const double radius = std::sqrt(-2 * std::log(1 - unit(hash(seed, i, 1u))));
    const double gaussian = radius * std::cos(2 * std::numbers::pi * unit(hash(seed, i, 2u)));
    noise_[i] =
        static_cast<int16_t>(std::lround(std::clamp(16 * response.noise_sigma * gaussian, -8000.0, 8000.0)));
  }
}

void Sensor::develop(const uint64_t* light, const uint16_t* falloff, int pixels, uint64_t noise_key,
                     uint8_t* bgr) const {
  int16_t level[3 * kMostPixels];
  for (int i = 0; i < pixels; ++i) {
    const uint32_t share = falloff[i];
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t arrived = static_cast<uint16_t>(light[i] >> 16 * c) * share;  // 8.24 fixed point
      level[3 * i + c] = curve_[c][(arrived + (1u << 21)) >> 22];
    }
  }
  const int16_t* noise = &noise_[hash(noise_key) % kNoise];
  for (int i = 0; i < 3 * pixels; ++i) {
    const int value = (level[i] + noise[i] + 8) >> 4;
    bgr[i] = static_cast<uint8_t>(std::clamp(value, 0, 255));
  }
}

}  // namespace svchain::scene
