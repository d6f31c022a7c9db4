#pragma once
// Geometric alignment by features of the overlaps (algorithms/registration), as the link uses it.

#include <array>
#include <opencv2/core/mat.hpp>

#include "algorithms/registration/alignment.h"
#include "links/geometric_alignment/ground_alignment.h"

namespace svchain {

/// The pictures, front, right, rear, left, as they are aligned from where the nominal rig says that the
/// cameras are, good to a tape's accuracy, on as much ground and as finely as the paper's composite of
/// 880 x 1080 px has it.
registration::AlignmentTask alignment_task(const geometry::Rig& nominal,
                                           const std::array<cv::Mat, 4>& pictures);

/// Aligns the pictures, however small the composite is. Too few features in an overlap are a reason to
/// reject. Stage times as in align_by_charts().
GroundAlignment align_by_features(const geometry::Rig& nominal, const std::array<cv::Mat, 4>& pictures,
                                  bool with_times);

}  // namespace svchain
