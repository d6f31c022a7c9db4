#include "links/shown_frame.h"

#include "algorithms/colour/convert.h"
#include "links/image.h"

namespace svchain {

cv::Mat ShownFrame::of(const Frame& frame, int buffer) {
  const colour::Picture picture = any_picture(frame, buffer);
  if (picture.format == colour::PixelFormat::kBgr8) return bgr_picture(frame, buffer);
  const std::byte* const from = frame.bytes(buffer).data();
  if (from == converted_from_ && frame.sequence() == converted_sequence_) return converted_;
  converted_from_ = from;
  converted_sequence_ = frame.sequence();
  converted_.create(picture.height_px, picture.width_px, CV_8UC3);
  colour::bgr_from(picture, colour::bgr_picture(converted_));
  return converted_;
}

}  // namespace svchain
