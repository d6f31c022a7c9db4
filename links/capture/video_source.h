#pragma once
// A video file for each camera, to their end. What its container says of size and length is believed until it
// shows to be wrong: then read() throws.

#include "links/capture/frame_source.h"
#include "links/capture/source_folder.h"

namespace svchain {

Result<std::unique_ptr<FrameSource>> open_videos(const SourceFolder& folder, const SourceRequest& request);

/// What the front camera's container says; nothing where it cannot be opened.
std::optional<double> video_fps(const SourceFolder& folder);

}  // namespace svchain
