#pragma once
// Rigs from the WoodScape data set's calibration files, one JSON for each of its cameras FV, MVR, RV, MVL
// (which the file says itself, as "name"). Its polynomial is ours; its centre is an offset from the image's
// middle. Its vehicle frame is ISO 8855 with the origin below the middle of the rear axle, which says nothing
// of the car's length: the vehicle comes from a nominal rig, and the poses are moved along x so that the
// front and the rear camera are as far ahead of the vehicle's middle, on average, as that rig's. All faults
// at once.

#include <filesystem>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

Result<Rig> import_woodscape(const std::vector<std::filesystem::path>& files, const Rig& nominal);

}  // namespace svchain::geometry
