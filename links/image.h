#pragma once
// Frames as OpenCV pictures, without a copy. The picture borrows the frame's memory. Never allocates.

#include <opencv2/core/mat.hpp>

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

}  // namespace svchain
