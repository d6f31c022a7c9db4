#pragma once
// A box of a camera's frame, ready to be read at the places of a LUT. What a frame in YUV shows is what its
// pixels show, each turned to b, g, r with the chroma of its group (colour/yuv.h): the composite is byte by
// byte that of the frame converted as a whole. Borrows the frame; plain value.

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
  bool reaches_end = false;         // of the frame: right behind a pixel may lie foreign memory
  const uint8_t* end = nullptr;     // behind the frame's last byte, of luma where there is a plane of it
  const uint8_t* chroma_end = nullptr;
  const colour::YuvMatrix* matrix = nullptr;
};

}  // namespace svchain::synthesis
