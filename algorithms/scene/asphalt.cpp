#include "algorithms/scene/asphalt.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scene/hash.h"

namespace svchain::scene {

namespace {

constexpr int kTile = 512;  // texels of the finest level
constexpr int kLevels = 10;

/// Mean 0, variance 1, near enough to a Gaussian: the sum of the four 16-bit parts of a word.
float gaussian(uint64_t word) {
  const double sum =
      static_cast<double>((word & 0xffff) + (word >> 16 & 0xffff) + (word >> 32 & 0xffff) + (word >> 48));
  return static_cast<float>((sum / 65535 - 2) * std::sqrt(3.0));
}

/// Running mean of 2 r + 1 neighbours along rows, the tile being a ring; transposed, so that twice is both
/// ways.
std::vector<float> smoothed_and_turned(const std::vector<float>& tile, int r) {
  std::vector<float> out(tile.size());
  for (int y = 0; y < kTile; ++y) {
    const float* row = &tile[static_cast<size_t>(y * kTile)];
    float sum = 0;
    for (int x = -r; x <= r; ++x) sum += row[x & (kTile - 1)];
    for (int x = 0; x < kTile; ++x) {
      out[static_cast<size_t>(x * kTile + y)] = sum;
      sum += row[(x + r + 1) & (kTile - 1)] - row[(x - r) & (kTile - 1)];
    }
  }
  return out;
}

void normalise(std::vector<float>& tile, double deviation) {
  double sum = 0, squares = 0;
  for (float v : tile) sum += v, squares += v * v;
  const double n = static_cast<double>(tile.size());
  const double mean = sum / n;
  const double scale = deviation / std::sqrt(std::max(1e-12, squares / n - mean * mean));
  for (float& v : tile) v = static_cast<float>((v - mean) * scale);
}

/// Stones of the grain's size, and dust as fine as the texels.
std::vector<float> grain_tile(double grain_texels, double contrast, uint64_t seed) {
  std::vector<float> dust(static_cast<size_t>(kTile) * kTile);
  for (size_t i = 0; i < dust.size(); ++i) dust[i] = gaussian(hash(seed, i));
  const int r = std::clamp(static_cast<int>(std::lround(grain_texels / 2)), 0, kTile / 4);
  std::vector<float> stones = smoothed_and_turned(smoothed_and_turned(dust, r), r);
  normalise(stones, 0.8);
  normalise(dust, 0.6);
  for (size_t i = 0; i < dust.size(); ++i) stones[i] += dust[i];
  normalise(stones, contrast);
  return stones;
}

std::vector<float> halved(const std::vector<float>& tile, int side) {
  std::vector<float> coarse(tile.size() / 4);
  for (int y = 0; y < side / 2; ++y) {
    for (int x = 0; x < side / 2; ++x) {
      const float* at = &tile[static_cast<size_t>(2 * y * side + 2 * x)];
      coarse[static_cast<size_t>(y * side / 2 + x)] = (at[0] + at[1] + at[side] + at[side + 1]) / 4;
    }
  }
  return coarse;
}

/// Value noise: random values on a lattice, smoothly joined. Two octaves, about -1 to 1.
class Blotches {
 public:
  Blotches(double size_m, uint64_t seed) : size_m_(size_m), seed_(seed) {}

  float at(double x_m, double y_m) const {
    return static_cast<float>(0.7 * octave(x_m / size_m_, y_m / size_m_, 0) +
                              0.5 * octave(x_m / size_m_ * 2.7, y_m / size_m_ * 2.7, 1));
  }

 private:
  double node(int64_t i, int64_t j, int octave) const { return 2 * unit(hash(seed_, i, j, octave)) - 1; }
  double octave(double x, double y, int octave) const {
    const double i = std::floor(x), j = std::floor(y);
    const double a = (x - i) * (x - i) * (3 - 2 * (x - i));
    const double b = (y - j) * (y - j) * (3 - 2 * (y - j));
    const auto n = [&](int di, int dj) {
      return node(static_cast<int64_t>(i) + di, static_cast<int64_t>(j) + dj, octave);
    };
    return (1 - b) * ((1 - a) * n(0, 0) + a * n(1, 0)) + b * ((1 - a) * n(0, 1) + a * n(1, 1));
  }
  double size_m_;
  uint64_t seed_;
};

}  // namespace

Asphalt::Asphalt(const Ground& ground, double finest_metres_per_texel, uint64_t seed)
    : ground_(ground), finest_metres_per_texel_(finest_metres_per_texel), seed_(seed) {
  grain_.push_back(grain_tile(ground.grain_m / finest_metres_per_texel, ground.grain_contrast, seed));
  for (int level = 1; level < kLevels; ++level) grain_.push_back(halved(grain_.back(), kTile >> (level - 1)));
}

Texture Asphalt::lay(int level, int texels_a_side) const {
  constexpr int kStep = 16;  // texels between the places where the blotches are worked out
  const int tile_side = kTile >> std::min(level, kLevels - 1);
  const std::vector<float>& tile = grain_[static_cast<size_t>(std::min(level, kLevels - 1))];
  const double metres_per_texel = std::ldexp(finest_metres_per_texel_, level);
  const double half = metres_per_texel * texels_a_side / 2;
  const Blotches blotches(ground_.blotch_m, hash(seed_, 1u));
  const float contrast = static_cast<float>(ground_.blotch_contrast / 0.35);  // of the noise's own deviation

  const int nodes = texels_a_side / kStep + 2;
  std::vector<float> coarse(static_cast<size_t>(nodes) * nodes);
  for (int j = 0; j < nodes; ++j) {
    for (int i = 0; i < nodes; ++i) {
      const double x = (i * kStep + 0.5) * metres_per_texel - half;
      const double y = (j * kStep + 0.5) * metres_per_texel - half;
      coarse[static_cast<size_t>(j * nodes + i)] = 1 + contrast * blotches.at(x, y);
    }
  }

  Texture texture(texels_a_side, texels_a_side);
  std::vector<float> shade(static_cast<size_t>(texels_a_side));
  const auto b = static_cast<float>(ground_.colour.b);
  const auto g = static_cast<float>(ground_.colour.g);
  const auto r = static_cast<float>(ground_.colour.r);
  for (int y = 0; y < texels_a_side; ++y) {
    const float* upper = &coarse[static_cast<size_t>(y / kStep * nodes)];
    const float* grain = &tile[static_cast<size_t>((y & (tile_side - 1)) * tile_side)];
    const float beta = static_cast<float>(y % kStep) / kStep;
    for (int x = 0; x < texels_a_side; ++x) {
      const float* at = upper + x / kStep;
      const float alpha = static_cast<float>(x % kStep) / kStep;
      const float left = at[0] + beta * (at[nodes] - at[0]);
      const float right = at[1] + beta * (at[nodes + 1] - at[1]);
      const float light = left + alpha * (right - left) + grain[x & (tile_side - 1)];
      shade[static_cast<size_t>(x)] = std::clamp(light, 0.f, 2.5f);
    }
    uint32_t* out = texture.row(y);
    for (int x = 0; x < texels_a_side; ++x) {
      const float s = shade[static_cast<size_t>(x)];
      const auto channel = [s](float c) {
        return static_cast<uint32_t>(std::min(static_cast<int>(s * c + 0.5f), 255));
      };
      out[x] = channel(b) | channel(g) << 8 | channel(r) << 16;
    }
  }
  return texture;
}

}  // namespace svchain::scene
