#pragma once
// What each pixel of a camera looks at, worked out once: a place on the ground in the vehicle's frame, or a
// direction to the surroundings, or nothing where the lens does not reach. Plain values; immutable after the
// making.

#include <cstdint>
#include <vector>

#include "algorithms/scene/world.h"

namespace svchain::scene {

/// Neighbours in a row that are sampled in the same way.
struct Span {
  static constexpr uint8_t kNothing = 255;
  static constexpr uint8_t kPanorama = 254;
  uint16_t first = 0;
  uint16_t count = 0;
  uint8_t target = kNothing;  // a level of the ground, or one of these
  uint8_t taps_log2 = 0;      // samples along a pixel's footprint on the ground
};

struct SightLines {
  int width = 0;
  int height = 0;
  std::vector<Span> spans;
  std::vector<size_t> first_span;  // of each row, and the end of the last
  /// By pixel: x, y in the vehicle's frame in texels of the target level; or azimuth, elevation in texels.
  std::vector<float> x, y;
  /// By pixel: distance between taps, relative to the distance of the ground point from the camera's foot.
  std::vector<float> stretch;
  std::vector<uint16_t> falloff;
  double foot_x_m = 0, foot_y_m = 0;
};

/// By pixel, row by row: 65535 / (1 + f1 q^2 + f2 q^4), the lens's falloff.
std::vector<uint16_t> falloff_by_pixel(const Scene& scene, size_t camera);

SightLines trace_sight_lines(const World& world, size_t camera);

}  // namespace svchain::scene
