#pragma once
// Which of four files belongs to which camera, told by their names.

#include <array>
#include <filesystem>
#include <vector>

#include "algorithms/json/fault.h"

namespace svchain::geometry {

/// The files of the front, right, rear and left camera: the one whose name holds that word ("back" is taken
/// for "rear"). Faults: a camera without a file or with two, a file of no camera.
Result<std::array<std::filesystem::path, 4>> camera_files(const std::vector<std::filesystem::path>& files);

}  // namespace svchain::geometry
