#include "links/bowl/view_inputs.h"

#include <cstring>

#include "links/image.h"

namespace svchain {

std::vector<PortDescription> view_inputs() {
  return {{.name = "frames",
           .types = {"bgr8", "nv12", "yuyv"},
           .count = BowlPainter::kCameraCount,
           .help = "sets of four, front right rear left"},
          {.name = "tone_mapping",
           .types = {"tone_mapping"},
           .count = 1,
           .optional = true,
           .help = "applied to the next frame; the identity before the first"}};
}

double ViewInputs::take(const Call& call, int frames_port, int tone_mapping_port) {
  if (const Frame& curves = call.input(tone_mapping_port))
    std::memcpy(&tone_mapping, curves.bytes().data(), sizeof(tone_mapping));
  const Frame& set = call.input(frames_port);
  for (size_t c = 0; c < frames.size(); ++c) frames[c] = any_picture(set, static_cast<int>(c));
  if (!first_ns) first_ns = set.timestamp_ns();
  return static_cast<double>(set.timestamp_ns() - *first_ns) * 1e-9;
}

}  // namespace svchain
