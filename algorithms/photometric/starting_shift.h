#pragma once
// By which gain each camera has changed since the curves in force: robust where least squares is not. Per
// channel and pair of cameras the median of ln(first / second) over the blocks, then the shifts that leave
// the smallest sum of absolute differences. Where the medians leave a choice, as few cameras as possible have
// changed: what stands in one overlap is no camera's change, and a camera that exposes anew moves no other.

#include <array>
#include <vector>

#include "algorithms/photometric/evidence.h"

namespace svchain::photometric {

/// [camera][channel], ln.
using Shifts = std::array<std::array<double, synthesis::kChannels>, synthesis::kMaxCameras>;

/// `scratch` has to hold a value for every block; nothing is allocated then.
Shifts starting_shifts(const Evidence& evidence, const ToneCurves& curves, size_t cameras,
                       std::vector<double>& scratch);

}  // namespace svchain::photometric
