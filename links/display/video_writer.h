#pragma once
// Videos: H.264 in .mp4 to share, FFV1 in .mkv without loss.

#include "links/display/frame_writer.h"

namespace svchain {

/// Tries whether the encoder is there.
Result<std::unique_ptr<FrameWriter>> make_video_writer(const std::filesystem::path& file,
                                                       const WriterRequest& request);

}  // namespace svchain
