#pragma once
// Cameras that wait for nobody: devices, network streams, anything that OpenCV opens by number or URL. One
// thread for each camera does the blocking reads and keeps the newest frame; what has not been fetched by
// then is replaced. A camera whose stream ends is gone, the others go on; with the last one the source has
// ended.

#include "links/capture/frame_source.h"

namespace svchain {

Result<std::unique_ptr<FrameSource>> open_live(const std::array<std::string, kCameras>& urls);

}  // namespace svchain
