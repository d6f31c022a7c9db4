#pragma once
// How synthesis reads a camera's frame: straight from the bytes of its format, at the places of a LUT. YUV is
// sampled as it is, Y of the pixels and U and V of their groups, each by `bilinear` of fixed_point.h; the
// sample alone is turned into b, g, r (colour/yuv.h). No frame is ever converted as a whole. Were it, samples
// would differ by 2 levels at most, except where a group's chroma takes a pixel beyond what RGB holds (blown
// highlights, edges of strong colours): there every pixel would be clamped, and here the sample is.

#include <cstddef>
#include <cstdint>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::synthesis {

/// Samples of a span, channel by channel (b, g, r), so that what follows runs over plain arrays.
struct Samples {
  uint8_t channel[kChannels][kBlockSize];
};

/// A box of a camera's frame. Borrows the frame; any thread.
class FrameBox {
 public:
  FrameBox() = default;
  FrameBox(const colour::Picture& frame, const LutSource& box);

  /// `count` (at most 40) samples at entries of the LUT; black where the frame is empty. Reads no byte
  /// outside the box, but for the whole groups of chroma that it touches.
  void sample(const uint32_t* entries, int count, Samples& samples) const {
    sample_(*this, entries, count, samples);
  }

 private:
  using Sampler = void (*)(const FrameBox&, const uint32_t* entries, int count, Samples& samples);

  static void sample_black(const FrameBox& box, const uint32_t* entries, int count, Samples& samples);
  static void sample_bgr(const FrameBox& box, const uint32_t* entries, int count, Samples& samples);
  template <colour::YuvLayout kLayout>
  static void sample_yuv(const FrameBox& box, const uint32_t* entries, int count, Samples& samples);

  const uint8_t* origin_ = nullptr;  // top left pixel of the box, or its Y
  size_t pitch_ = 0;
  const uint8_t* chroma_ = nullptr;  // U of the box's first group
  uint32_t odd_x_ = 0, odd_y_ = 0;   // 1 where the box begins in the middle of a group
  const colour::YuvMatrix* matrix_ = nullptr;
  Sampler sample_ = sample_black;
};

}  // namespace svchain::synthesis
