#include "algorithms/synthesis/frame_box.h"

namespace svchain::synthesis {

using colour::PixelFormat;

FrameBox::FrameBox(const colour::Picture& frame, const LutSource& box)
    : format(frame.format), pitch(frame.pitch_bytes) {
  if (frame.empty()) return;
  reaches_end = box.x + box.width >= frame.width_px - 1 && box.y + box.height >= frame.height_px - 1;
  origin = frame.pixels + box.y * pitch;
  if (format == PixelFormat::kBgr8) {
    origin += box.x * 3;
    return;
  }
  const colour::YuvLayout layout = format == PixelFormat::kNv12 ? colour::kNv12Layout : colour::kYuyvLayout;
  end = frame.pixels + (frame.height_px - 1) * pitch + frame.width_px * layout.luma_step;
  chroma_end = format == PixelFormat::kYuyv
                   ? end
                   : frame.chroma + (frame.height_px / layout.rows - 1) * pitch + frame.width_px;
  origin += box.x * layout.luma_step;
  chroma = frame.chroma + box.y / layout.rows * pitch + box.x / 2 * layout.chroma_step;
  odd_x = box.x % 2;
  odd_y = box.y % layout.rows;
  matrix = &colour::yuv_matrix(frame.encoding);
}

}  // namespace svchain::synthesis
