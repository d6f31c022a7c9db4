#include "algorithms/synthesis/prefetch.h"

namespace svchain::synthesis {
namespace {

using colour::Picture;
using colour::PixelFormat;

constexpr uintptr_t kCacheLine = 64;

void prefetch_bytes(const uint8_t* begin, size_t count) {
  const uint8_t* const end = begin + count;
  for (const uint8_t* line = begin - reinterpret_cast<uintptr_t>(begin) % kCacheLine; line < end;
       line += kCacheLine)
    __builtin_prefetch(line, 0, 3);
}

size_t bytes_per_px(PixelFormat format) {
  return format == PixelFormat::kBgr8 ? 3 : format == PixelFormat::kYuyv ? 2 : 1;
}

}  // namespace

void prefetch(const GeometricLut& lut, const LutBlock& block, std::span<const Picture> frames) {
  if (block.row_count == 0) return;
  const LutRow* row = lut.rows(block).data();
  for (const LutSource& source : std::span(block.sources).first(block.source_count)) {
    const Picture& frame = frames[source.camera];
    if (frame.empty()) {
      row += source.height;
      continue;
    }
    const size_t pixel = bytes_per_px(frame.format);
    for (size_t y = source.y; y < size_t{source.y} + source.height; ++y, ++row) {
      if (row->count == 0) continue;
      const size_t start = size_t{source.x} + row->start;
      prefetch_bytes(frame.pixels + y * frame.pitch_bytes + start * pixel, row->count * pixel);
      if (frame.format == PixelFormat::kNv12 && y % 2 == 0)
        prefetch_bytes(frame.chroma + y / 2 * frame.pitch_bytes + start / 2 * 2, size_t{row->count} + 1);
    }
  }
}

}  // namespace svchain::synthesis
