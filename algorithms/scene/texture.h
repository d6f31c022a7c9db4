#pragma once
// A picture to sample from: texels 0x00RRGGBB, row by row. Owns its texels.

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <vector>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

static_assert(std::endian::native == std::endian::little, "the renderer reads texels as bytes B, G, R");

struct Texture {
  int width = 0;
  int height = 0;
  std::vector<uint32_t> texels;

  Texture() = default;
  Texture(int columns, int rows)
      : width(columns), height(rows), texels(static_cast<size_t>(columns) * static_cast<size_t>(rows)) {}

  uint32_t* row(int y) { return texels.data() + static_cast<size_t>(y) * static_cast<size_t>(width); }
  const uint32_t* row(int y) const {
    return texels.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
  }
};

constexpr uint32_t texel(Colour c) {
  return c.b | static_cast<uint32_t>(c.g) << 8 | static_cast<uint32_t>(c.r) << 16;
}

/// B, G, R at column u, row v, bilinear; texel centres at whole numbers, the edge's texels beyond the edge.
Eigen::Vector3d sample(const Texture& texture, double u, double v);

/// Half the size, each texel the mean of four. The sizes have to be even.
Texture halved(const Texture& fine);

}  // namespace svchain::scene
