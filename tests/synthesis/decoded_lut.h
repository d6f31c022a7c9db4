#pragma once
// A LUT spelled out pixel by pixel, for comparing with what it should hold.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "algorithms/synthesis/lut_pixels.h"

namespace svchain::testing {

/// A LUT with the memory it lives in.
class OwnedLut {
 public:
  OwnedLut(const geometry::Rig& rig, const geometry::View& view, const synthesis::BlendShape& shape = {})
      : memory_(synthesis::geometric_lut_capacity(view, rig.cameras.size())),
        bytes_(synthesis::build_geometric_lut(rig, view, shape, memory_)) {}

  synthesis::GeometricLut lut() const { return synthesis::GeometricLut(bytes()); }
  std::span<const std::byte> bytes() const { return std::span<const std::byte>(memory_).first(bytes_); }
  size_t capacity() const { return memory_.size(); }

 private:
  std::vector<std::byte> memory_;
  size_t bytes_;
};

/// A place in a camera's image: whole pixel and 32nds.
struct DecodedTap {
  int camera = -1;
  int x = 0, y = 0, fx = 0, fy = 0;

  double px() const { return x + fx / 32.0; }
  double py() const { return y + fy / 32.0; }
};

struct DecodedPixel {
  int times_covered = 0;
  synthesis::RegionKind kind = synthesis::RegionKind::kBlack;
  std::array<DecodedTap, 2> taps;
  int weight = 0;
  std::array<uint8_t, 3> background = {};
  uint32_t block = 0;

  int tap_count() const {
    return kind == synthesis::RegionKind::kBlend ? 2 : kind == synthesis::RegionKind::kCamera ? 1 : 0;
  }
  /// Weight of a camera in this pixel, 0..255.
  int weight_of(int camera) const {
    if (tap_count() == 1) return taps[0].camera == camera ? 255 : 0;
    if (tap_count() == 0) return 0;
    return taps[0].camera == camera ? weight : taps[1].camera == camera ? 255 - weight : 0;
  }
};

struct DecodedLut {
  int width = 0, height = 0;
  std::vector<DecodedPixel> pixels;

  const DecodedPixel& at(int column, int row) const { return pixels[size_t(row) * width + column]; }
};

inline DecodedLut decode(const synthesis::GeometricLut& lut) {
  DecodedLut decoded{lut.header().width, lut.header().height, {}};
  decoded.pixels.resize(size_t(decoded.width) * decoded.height);
  uint32_t index = 0;
  for (const auto& block : lut.blocks()) {
    synthesis::for_each_pixel(lut, block, [&](const synthesis::LutPixel& from) {
      const synthesis::LutRegion& region = *from.region;
      const auto tap = [&](int source_index, uint32_t entry) {
        const auto& source = block.sources[source_index];
        const uint32_t x = synthesis::entry_x(entry), y = synthesis::entry_y(entry);
        return DecodedTap{source.camera, int(source.x + x / 32), int(source.y + y / 32), int(x % 32),
                          int(y % 32)};
      };
      DecodedPixel& pixel = decoded.pixels[size_t(from.row) * decoded.width + from.column];
      ++pixel.times_covered;
      pixel.kind = region.kind;
      pixel.block = index;
      if (region.tap_count() > 0) pixel.taps[0] = tap(region.first, from.first);
      if (region.tap_count() > 1) pixel.taps[1] = tap(region.second, from.second);
      pixel.weight = from.weight;
      if (from.background) std::copy_n(from.background, 3, pixel.background.begin());
    });
    ++index;
  }
  return decoded;
}

}  // namespace svchain::testing
