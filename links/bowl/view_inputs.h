#pragma once
// What every link that shows the bowl takes in: four frames, and the tone mapping in force. Its core's
// thread.

#include <optional>
#include <vector>

#include "framework/link/description.h"
#include "links/bowl/bowl_painter.h"

namespace svchain {

/// "frames" and, optional, "tone_mapping".
std::vector<PortDescription> view_inputs();

struct ViewInputs {
  BowlPainter::Frames frames;
  synthesis::ToneMapping tone_mapping = synthesis::ToneMapping::identity();
  std::optional<int64_t> first_ns;

  /// Takes in the call's. Returns the time since the first frame, in seconds.
  double take(const Call& call, int frames_port, int tone_mapping_port);
};

}  // namespace svchain
