#pragma once
// Geometric alignment by charts on the ground (algorithms/calibration), as the link uses it.

#include <array>
#include <opencv2/core/mat.hpp>

#include "algorithms/calibration/charts.h"
#include "framework/link/link.h"
#include "links/geometric_alignment/alignment_settings.h"
#include "links/geometric_alignment/ground_alignment.h"

namespace svchain {

/// The charts of a file, or of a name in configs/charts; where `named` is empty, those of the simulated scene
/// that frames come from. Faults go to the configuration, with an empty list.
std::vector<calibration::Chart> charts_in_use(Configuration& configuration, const std::string& named);

/// Calibrates from the pictures, front, right, rear, left, and from the rig's poses or the pictures' content
/// alone. Stage times are left out of the report where they
/// are not wanted, for they differ from run to run.
GroundAlignment align_by_charts(const AlignmentSettings& settings, const std::array<cv::Mat, 4>& pictures,
                                bool with_times);

}  // namespace svchain
