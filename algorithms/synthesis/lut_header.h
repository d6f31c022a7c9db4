#pragma once
// How every LUT begins, whatever it is of. Plain function, any thread.

#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

/// Everything but the length, the count of overlaps and what only a view of the ground has, which are 0.
void fill_header(LutHeader& header, const geometry::Rig& rig, const Eigen::Vector2i& size_px);

}  // namespace svchain::synthesis
