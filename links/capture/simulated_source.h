#pragma once
// The simulated world as seen by its four cameras, 300 sets where nobody says how many.

#include <filesystem>

#include "links/capture/frame_source.h"

namespace svchain {

/// The file of a scene: the name of one that comes with the program, or a path.
Result<std::filesystem::path> find_scene(const std::string& scene);
/// `scene`: the name of a scene that comes with the program, or a scene file.
Result<std::unique_ptr<FrameSource>> open_simulated(const std::string& scene, const SourceRequest& request);

}  // namespace svchain
