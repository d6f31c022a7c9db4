#pragma once
// Reads scene files (schema: configs/schemas/scene.schema.json).

#include <filesystem>
#include <string>

#include "algorithms/json/fault.h"
#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// The scene with its rig, or every fault in either file.
Result<Scene> read_scene(const std::filesystem::path& path);
/// The same from a text, `file` being what messages call it and what the rig's file name is relative to.
Result<Scene> parse_scene(const std::string& text, const std::string& file);

}  // namespace svchain::scene
