#pragma once
// A LUT spelled out pixel by pixel, for comparing with what it should hold.

#include <cstddef>
#include <vector>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/geometric_lut.h"

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
  synthesis::SpanKind kind = synthesis::SpanKind::kBlack;
  std::array<DecodedTap, 2> taps;
  int weight = 0;
  std::array<uint8_t, 3> background = {};
  uint32_t block = 0;

  int tap_count() const {
    return kind == synthesis::SpanKind::kBlend ? 2 : kind == synthesis::SpanKind::kCamera ? 1 : 0;
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
  using synthesis::SpanKind;
  DecodedLut decoded{lut.header().width, lut.header().height, {}};
  decoded.pixels.resize(size_t(decoded.width) * decoded.height);
  uint32_t index = 0;
  for (const auto& block : lut.blocks()) {
    const uint32_t* entries = lut.entries(block);
    const uint8_t* weights = lut.weights(block);
    const uint8_t* background = lut.background(block);
    const auto tap = [&](int source_index) {
      const auto& source = block.sources[source_index];
      const uint32_t x = synthesis::entry_x(*entries), y = synthesis::entry_y(*entries);
      ++entries;
      return DecodedTap{source.camera, int(source.x + x / 32), int(source.y + y / 32), int(x % 32),
                        int(y % 32)};
    };
    for (const auto& span : lut.spans(block)) {
      DecodedPixel* run = &decoded.pixels[size_t(block.y + span.row) * decoded.width + block.x + span.start];
      for (int i = 0; i < span.count; ++i) {
        ++run[i].times_covered;
        run[i].kind = span.kind;
        run[i].block = index;
      }
      if (span.kind == SpanKind::kCamera || span.kind == SpanKind::kBlend)
        for (int i = 0; i < span.count; ++i) run[i].taps[0] = tap(span.first);
      if (span.kind == SpanKind::kBlend)
        for (int i = 0; i < span.count; ++i) run[i].taps[1] = tap(span.second);
      if (span.kind == SpanKind::kBlend)
        for (int i = 0; i < span.count; ++i) run[i].weight = *weights++;
      if (span.kind == SpanKind::kBackground)
        for (int i = 0; i < span.count; ++i)
          for (uint8_t& channel : run[i].background) channel = *background++;
    }
    ++index;
  }
  return decoded;
}

}  // namespace svchain::testing
