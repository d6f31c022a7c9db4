#include "algorithms/synthesis/converted_boxes.h"

namespace svchain::synthesis {
namespace {

/// Conversion may write a pixel before a row and whole vectors behind it; sampling may read behind it.
constexpr size_t kBefore = kLargestVector, kBehind = 2 * kLargestVector * kChannels;

}  // namespace

FrameBox ConvertedBoxes::box(const colour::Picture& frame, const LutSource& source,
                             std::span<const LutRow> rows, const Stages& stages) {
  const FrameBox own(frame, source);
  if (own.empty() || own.format == colour::PixelFormat::kBgr8 || rows.empty()) return own;
  const size_t pitch = (size_t{source.width} + 2) * kChannels;
  const size_t bytes = kBefore + rows.size() * pitch + kBehind;
  if (bytes > kBytes - used_) return own;
  FrameBox converted;
  converted.origin = bytes_ + used_ + kBefore;
  converted.pitch = pitch;
  stages.turn_to_bgr(own, rows, bytes_ + used_ + kBefore, pitch);
  used_ += bytes;
  return converted;
}

}  // namespace svchain::synthesis
