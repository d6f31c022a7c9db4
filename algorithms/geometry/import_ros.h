#pragma once
// Rigs from ROS's camera_info YAML files, as its camera_calibration writes them: `equidistant` is a
// Kannala-Brandt lens, `plumb_bob` a pinhole. One file for each camera, told by its name; poses and vehicle
// come from a nominal rig. Only camera_matrix and distortion_coefficients are read of the matrices. All
// faults at once.

#include <filesystem>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

Result<Rig> import_ros(const std::vector<std::filesystem::path>& files, const Rig& nominal);

}  // namespace svchain::geometry
