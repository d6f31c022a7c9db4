#include "algorithms/colour/picture.h"

namespace svchain::colour {

Picture bgr_picture(const cv::Mat& bgr) {
  return {PixelFormat::kBgr8, {}, bgr.cols, bgr.rows, bgr.empty() ? 0 : bgr.step[0], bgr.data, nullptr};
}

Picture bgrx_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data) {
  return {PixelFormat::kBgrx8, {}, width_px, height_px, pitch_bytes, data, nullptr};
}

Picture nv12_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data, YuvEncoding encoding) {
  uint8_t* chroma = data + static_cast<size_t>(height_px) * pitch_bytes;
  return {PixelFormat::kNv12, encoding, width_px, height_px, pitch_bytes, data, chroma};
}

Picture yuyv_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data, YuvEncoding encoding) {
  return {PixelFormat::kYuyv, encoding, width_px, height_px, pitch_bytes, data, data + 1};
}

bool has_whole_groups(PixelFormat format, int width_px, int height_px) {
  if (!is_yuv(format)) return true;
  return width_px % 2 == 0 && (format == PixelFormat::kYuyv || height_px % 2 == 0);
}

}  // namespace svchain::colour
