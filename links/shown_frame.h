#pragma once
// What a frame of any format shows, as BGR: for OpenCV, files and eyes. One thread.

#include <opencv2/core/mat.hpp>

#include "framework/buffer/frame.h"

namespace svchain {

class ShownFrame {
 public:
  /// A BGR frame as it lies; any other converted, once however often it is asked for, into memory that
  /// belongs to this object, is made with the first frame and written again by the next. To be read only.
  /// Empty where a set has nothing at this place.
  cv::Mat of(const Frame& frame, int buffer = 0);

 private:
  cv::Mat converted_;
  const std::byte* converted_from_ = nullptr;
  uint64_t converted_sequence_ = 0;
};

}  // namespace svchain
