#pragma once
// Frames as pictures, without a copy: for OpenCV where they are BGR, for our own arithmetic in any format.
// The picture borrows the frame's memory. Never allocates.

#include <cassert>
#include <opencv2/core/mat.hpp>

#include "algorithms/colour/picture.h"
#include "framework/buffer/frame.h"

namespace svchain {

inline cv::Mat bgr_picture(const Format& format, std::byte* data) {
  return cv::Mat(format.height_px, format.width_px, CV_8UC3, data, static_cast<size_t>(format.pitch_bytes));
}

/// Of a shared frame: to be read only. Empty where a set has nothing at this place.
inline cv::Mat bgr_picture(const Frame& frame, int buffer = 0) {
  if (!frame.has(buffer)) return {};
  return bgr_picture(frame.format(buffer), const_cast<std::byte*>(frame.bytes(buffer).data()));
}

inline cv::Mat bgr_picture(Draft& draft, int buffer = 0) {
  return bgr_picture(draft.format(buffer), draft.bytes(buffer).data());
}

/// bgr8, bgrx8, nv12 or yuyv.
inline colour::Picture any_picture(const Format& format, std::byte* data) {
  if (format.type == "bgr8") return colour::bgr_picture(bgr_picture(format, data));
  const auto pitch = static_cast<size_t>(format.pitch_bytes);
  auto* const pixels = reinterpret_cast<uint8_t*>(data);
  if (format.type == "bgrx8") return colour::bgrx_picture(format.width_px, format.height_px, pitch, pixels);
  const auto encoding = colour::yuv_encoding(format.colour);
  assert(encoding && (format.type == "nv12" || format.type == "yuyv"));
  const auto view = format.type == "nv12" ? colour::nv12_picture : colour::yuyv_picture;
  return view(format.width_px, format.height_px, pitch, pixels, *encoding);
}

/// Of a shared frame: to be read only. Empty where a set has nothing at this place.
inline colour::Picture any_picture(const Frame& frame, int buffer = 0) {
  if (!frame.has(buffer)) return {};
  return any_picture(frame.format(buffer), const_cast<std::byte*>(frame.bytes(buffer).data()));
}

inline colour::Picture any_picture(Draft& draft, int buffer = 0) {
  return any_picture(draft.format(buffer), draft.bytes(buffer).data());
}

}  // namespace svchain
