#pragma once
// What a directory has for each camera: a still, a folder of numbered frames, or a video; "back" is taken for
// "rear".

#include <array>
#include <filesystem>

#include "algorithms/json/fault.h"
#include "links/capture/frame_source.h"

namespace svchain {

enum class FolderKind { kStills, kNumbered, kVideos };

struct SourceFolder {
  FolderKind kind = FolderKind::kStills;
  std::array<std::filesystem::path, kCameras> paths;
};

/// Every fault: no such directory, cameras missing, two files for one camera, different kinds, unknown types.
Result<SourceFolder> look_into_folder(const std::filesystem::path& folder);

}  // namespace svchain
