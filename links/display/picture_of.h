#pragma once
// A frame's first buffer as OpenCV sees it: no copy, valid as long as the frame. BGR, 8 bits.

#include <opencv2/core.hpp>

#include "framework/buffer/frame.h"

namespace svchain {

inline cv::Mat picture_of(const Frame& frame) {
  const Format& format = frame.format();
  auto* bytes = const_cast<std::byte*>(frame.bytes().data());  // cv::Mat knows no const; it is only read
  return {format.height_px, format.width_px, CV_8UC3, bytes, static_cast<size_t>(format.pitch_bytes)};
}

}  // namespace svchain
