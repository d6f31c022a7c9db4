#pragma once
// Shows the frames on the screen.

#include "links/display/frame_writer.h"

namespace svchain {

/// Fails where there is no display.
Result<std::unique_ptr<FrameWriter>> make_window_writer();

}  // namespace svchain
