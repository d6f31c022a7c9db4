#include "algorithms/synthesis/sampling.h"

#include <cstring>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {

using colour::kNv12Layout;
using colour::kYuyvLayout;
using colour::Picture;
using colour::PixelFormat;
using colour::YuvLayout;

FrameBox::FrameBox(const Picture& frame, const LutSource& box) : pitch_(frame.pitch_bytes) {
  if (frame.empty()) return;
  origin_ = frame.pixels + box.y * pitch_;
  if (frame.format == PixelFormat::kBgr8) {
    origin_ += box.x * kChannels;
    sample_ = sample_bgr;
    return;
  }
  const bool nv12 = frame.format == PixelFormat::kNv12;
  const YuvLayout layout = nv12 ? kNv12Layout : kYuyvLayout;
  origin_ += box.x * layout.luma_step;
  chroma_ = frame.chroma + box.y / layout.rows * pitch_ + box.x / 2 * layout.chroma_step;
  odd_x_ = box.x % 2;
  odd_y_ = box.y % layout.rows;
  matrix_ = &colour::yuv_matrix(frame.encoding);
  sample_ = nv12 ? sample_yuv<kNv12Layout> : sample_yuv<kYuyvLayout>;
}

void FrameBox::sample_black(const FrameBox&, const uint32_t*, int, Samples& samples) {
  std::memset(&samples, 0, sizeof samples);
}

void FrameBox::sample_bgr(const FrameBox& box, const uint32_t* entries, int count, Samples& samples) {
  const uint8_t* const origin = box.origin_;
  const size_t pitch = box.pitch_;
  uint8_t* out = samples.channel[0];  // pointers that walk: 8 % faster here than indices
  for (const uint32_t* const end = entries + count; entries != end; ++entries, ++out) {
    const uint32_t x = entry_x(*entries), y = entry_y(*entries);
    const uint8_t* upper = origin + (y >> kFractionBits) * pitch + (x >> kFractionBits) * kChannels;
    const uint8_t* lower = upper + pitch;
    const uint32_t fx = x % kOnePixel, fy = y % kOnePixel;
    for (int c = 0; c < kChannels; ++c)
      out[c * kBlockSize] = bilinear(upper[c], upper[c + kChannels], lower[c], lower[c + kChannels], fx, fy);
  }
}

template <YuvLayout kLayout>
void FrameBox::sample_yuv(const FrameBox& box, const uint32_t* entries, int count, Samples& samples) {
  const colour::YuvMatrix& matrix = *box.matrix_;
  const size_t pitch = box.pitch_;
  uint8_t* out = samples.channel[0];
  for (const uint32_t* const end = entries + count; entries != end; ++entries, ++out) {
    const uint32_t x = entry_x(*entries), y = entry_y(*entries);
    const uint32_t fx = x % kOnePixel, fy = y % kOnePixel;
    const uint32_t column = x >> kFractionBits, row = y >> kFractionBits;
    const auto between = [&](const uint8_t* upper, const uint8_t* lower, uint32_t left, uint32_t right) {
      return bilinear(upper[left], upper[right], lower[left], lower[right], fx, fy);
    };
    const uint8_t* luma = box.origin_ + row * pitch + column * kLayout.luma_step;
    const uint8_t* upper = box.chroma_ + (row + box.odd_y_) / kLayout.rows * pitch;
    const uint8_t* lower = box.chroma_ + (row + box.odd_y_ + 1) / kLayout.rows * pitch;
    const uint32_t left = (column + box.odd_x_) / 2 * kLayout.chroma_step;
    const uint32_t right = (column + box.odd_x_ + 1) / 2 * kLayout.chroma_step;
    const colour::Bgr bgr = colour::bgr_of(
        matrix, between(luma, luma + pitch, 0, kLayout.luma_step), between(upper, lower, left, right),
        between(upper + kLayout.v_offset, lower + kLayout.v_offset, left, right));
    for (int c = 0; c < kChannels; ++c) out[c * kBlockSize] = bgr[c];
  }
}

}  // namespace svchain::synthesis
