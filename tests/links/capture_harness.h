#pragma once
// A capture alone, with its settings.

#include <opencv2/core.hpp>
#include <string>

#include "framework/testing/harness.h"
#include "links/capture/capture.h"

namespace svchain::testing {

struct CaptureAlone : LinkHarness {
  explicit CaptureAlone(const std::string& source, const std::string& rig = "")
      : LinkHarness(make_capture()) {
    setting("input", source);
    setting("rig", rig);
  }
};

inline cv::Vec3b pixel(const Frame& frame, int x, int y) {
  const Format& format = frame.format();
  const auto* bytes = reinterpret_cast<const uchar*>(frame.bytes().data());
  const uchar* p = bytes + y * format.pitch_bytes + 3 * x;
  return {p[0], p[1], p[2]};
}

/// Takes one set off the four outputs; false where one is missing.
inline bool drop_set(LinkHarness& capture) {
  bool all = true;
  for (const char* camera : {"front", "right", "rear", "left"}) all = capture.pop(camera).has_value() && all;
  return all;
}

}  // namespace svchain::testing
