#pragma once
// The charts of a simulated scene, as a calibration takes them. Pure.

#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/scene/scene.h"

namespace svchain::calibration {

/// Each where it lies at time 0.
std::vector<Chart> charts_of(const scene::Scene& scene);

}  // namespace svchain::calibration
