#pragma once
// What a buffer holds, agreed between two ports before anything runs. Plain values.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace svchain {

struct Format {
  std::string type;  // "bgr8", "nv12", ... for pictures; the name of a table otherwise: "geometric_lut"
  int width_px = 0;  // 0: not a picture
  int height_px = 0;
  int pitch_bytes = 0;  // from row to row
  size_t bytes = 0;     // of the whole buffer
  std::string colour;   // how a picture in YUV is meant: "bt601_limited", ... (algorithms/colour/yuv.h)

  bool operator==(const Format&) const = default;

  static Format bgr8(int width_px, int height_px) {
    return picture("bgr8", width_px * 3, width_px, height_px);
  }
  /// b g r and 255.
  static Format bgrx8(int width_px, int height_px) {
    return picture("bgrx8", width_px * 4, width_px, height_px);
  }
  /// Rows of Y, then half as many of U V U V, in one buffer and of one pitch. Width and height are even.
  static Format nv12(int width_px, int height_px, std::string colour) {
    Format format = picture("nv12", width_px, width_px, height_px, std::move(colour));
    format.bytes += format.bytes / 2;
    return format;
  }
  /// Y0 U Y1 V for every two pixels. The width is even.
  static Format yuyv(int width_px, int height_px, std::string colour) {
    return picture("yuyv", width_px * 2, width_px, height_px, std::move(colour));
  }
  static Format table(std::string type, size_t bytes) { return {std::move(type), 0, 0, 0, bytes, {}}; }

 private:
  static Format picture(std::string type, int row_bytes, int width_px, int height_px,
                        std::string colour = {}) {
    const int pitch = (row_bytes + 63) / 64 * 64;
    const auto bytes = static_cast<size_t>(pitch) * static_cast<size_t>(height_px);
    return {std::move(type), width_px, height_px, pitch, bytes, std::move(colour)};
  }
};

/// One entry for every buffer that a frame on this port carries: four for a set of four cameras.
using PortFormat = std::vector<Format>;

}  // namespace svchain
