#pragma once
// Rigs from Kalibr's camchain files. Lenses: `pinhole` with `equidistant` (a Kannala-Brandt lens), with
// `radtan` or `none`; `omni` with `radtan` or `none` (mei); `eucm`; `ds`. One file holds cam0, cam1, cam2,
// cam3 in the order front, right, rear, left; or four files hold a cam0 each and tell their camera by name.
// Poses and vehicle come from a nominal rig: T_cn_cnm1 knows nothing of a vehicle and is not read. All faults
// at once.

#include <filesystem>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

Result<Rig> import_kalibr(const std::vector<std::filesystem::path>& files, const Rig& nominal);

}  // namespace svchain::geometry
