#pragma once
// One still image for each camera, again and again. Decoded when opened.

#include "links/capture/frame_source.h"
#include "links/capture/source_folder.h"

namespace svchain {

Result<std::unique_ptr<FrameSource>> open_stills(const SourceFolder& folder, const SourceRequest& request);

}  // namespace svchain
