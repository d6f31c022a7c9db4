#pragma once
// A folder of numbered images for each camera, to their end. The first ones are decoded when opened, and all
// files are looked at for being cut off.

#include "links/capture/frame_source.h"
#include "links/capture/source_folder.h"

namespace svchain {

Result<std::unique_ptr<FrameSource>> open_numbered(const SourceFolder& folder, const SourceRequest& request);

}  // namespace svchain
