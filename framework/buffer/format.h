#pragma once
// What a buffer holds, agreed between two ports before anything runs. Plain values.

#include <cstddef>
#include <string>
#include <vector>

namespace svchain {

struct Format {
  std::string type;  // "bgr8", "nv12", ... for pictures; the name of a table otherwise: "geometric_lut"
  int width_px = 0;  // 0: not a picture
  int height_px = 0;
  int pitch_bytes = 0;  // from row to row
  size_t bytes = 0;     // of the whole buffer

  bool operator==(const Format&) const = default;

  static Format bgr8(int width_px, int height_px) {
    const int pitch = (width_px * 3 + 63) / 64 * 64;
    return {"bgr8", width_px, height_px, pitch, static_cast<size_t>(pitch) * static_cast<size_t>(height_px)};
  }
  static Format table(std::string type, size_t bytes) { return {std::move(type), 0, 0, 0, bytes}; }
};

/// One entry for every buffer that a frame on this port carries: four for a set of four cameras.
using PortFormat = std::vector<Format>;

}  // namespace svchain
