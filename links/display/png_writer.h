#pragma once
// Lossless pictures.

#include "links/display/frame_writer.h"

namespace svchain {

/// The last frame, encoded once, at the end.
std::unique_ptr<FrameWriter> make_last_frame_writer(const std::filesystem::path& file);
/// 000000.png, 000001.png, ... in a folder that is made when the first frame comes.
std::unique_ptr<FrameWriter> make_folder_writer(const std::filesystem::path& folder);

}  // namespace svchain
