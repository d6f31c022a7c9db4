#pragma once
// Rigs from OCamCalib's text files (calib_results.txt), one for each camera, told by its name; poses and
// vehicle come from a nominal rig. Such a file is, between lines that start with #: the direct polynomial (a
// count and so many numbers; not used), the inverse one (likewise), the centre's row and column, c d e,
// height and width. All faults at once.

#include <filesystem>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

Result<Rig> import_ocam(const std::vector<std::filesystem::path>& files, const Rig& nominal);

}  // namespace svchain::geometry
