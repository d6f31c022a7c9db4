#pragma once
// A box of a camera's frame, ready to be read at the places of a LUT, straight from the bytes of its format.
// YUV is sampled as it is, Y of the pixels and U and V of their groups, each by `bilinear` of fixed_point.h;
// the sample alone is turned into b, g, r (colour/yuv.h). No frame is ever converted as a whole. Were it,
// samples would differ by 2 levels at most, except where a group's chroma takes a pixel beyond what RGB holds
// (blown highlights, edges of strong colours): there every pixel would be clamped, and here the sample is.
// Borrows the frame; plain value.

#include <cstddef>
#include <cstdint>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

struct FrameBox {
  FrameBox() = default;
  FrameBox(const colour::Picture& frame, const LutSource& box);

  bool empty() const { return !origin; }

  colour::PixelFormat format = colour::PixelFormat::kBgr8;
  const uint8_t* origin = nullptr;  // top left pixel of the box, or its Y
  size_t pitch = 0;
  const uint8_t* chroma = nullptr;  // U of the box's first group
  uint32_t odd_x = 0, odd_y = 0;    // 1 where the box begins in the middle of a group
  bool reaches_end = false;         // of the frame: right behind a pixel or group may lie foreign memory
  const colour::YuvMatrix* matrix = nullptr;
};

}  // namespace svchain::synthesis
