#pragma once
// A picture in one of the formats that cameras give and displays take, as pointers to its bytes. Borrows its
// memory, as a cv::Mat over foreign memory does: what a function only reads it takes as const Picture&. Plain
// value.

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "algorithms/colour/yuv.h"

namespace svchain::colour {

enum class PixelFormat : uint8_t {
  kBgr8,  // b g r
  kNv12,  // a plane of Y; rows of U V, one of each for 2x2 pixels
  kYuyv,  // Y0 U Y1 V for two pixels
  kBgrx8  // b g r and a byte that is 255, so that it also serves as an opaque alpha; no camera gives it
};
constexpr bool is_yuv(PixelFormat format) {
  return format == PixelFormat::kNv12 || format == PixelFormat::kYuyv;
}
/// Of a row of pixels; NV12: of its plane of Y.
constexpr size_t bytes_per_px(PixelFormat format) {
  constexpr size_t kBytes[] = {3, 1, 2, 4};
  return kBytes[static_cast<size_t>(format)];
}

/// Where in a YUV picture things are: Y of pixel (x, y) at pixels + y pitch + x luma_step, U of its group at
/// chroma + (y / rows) pitch + (x / 2) chroma_step, V v_offset behind it.
struct YuvLayout {
  int luma_step, chroma_step, v_offset, rows;
};
inline constexpr YuvLayout kNv12Layout = {1, 2, 1, 2};
inline constexpr YuvLayout kYuyvLayout = {2, 4, 2, 1};

struct Picture {
  PixelFormat format = PixelFormat::kBgr8;
  YuvEncoding encoding = YuvEncoding::kBt601Limited;  // says nothing of BGR
  int width_px = 0;
  int height_px = 0;
  size_t pitch_bytes = 0;     // from row to row, of chroma as well
  uint8_t* pixels = nullptr;  // b of the first pixel, or its Y
  uint8_t* chroma = nullptr;  // the first U

  /// A camera that gave nothing.
  bool empty() const { return !pixels; }
};

/// Views; nothing is copied. NV12's rows of chroma follow its rows of luma at once.
Picture bgr_picture(const cv::Mat& bgr);
Picture bgrx_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data);
Picture nv12_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data, YuvEncoding encoding);
Picture yuyv_picture(int width_px, int height_px, size_t pitch_bytes, uint8_t* data, YuvEncoding encoding);

/// Whole groups of pixels: an even width, and for NV12 an even height.
bool has_whole_groups(PixelFormat format, int width_px, int height_px);

}  // namespace svchain::colour
