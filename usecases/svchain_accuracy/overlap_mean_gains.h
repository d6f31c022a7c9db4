#pragma once
// The baseline: what a common Python system does. One gain per camera and channel from the ratios of the
// overlaps' means, their geometric mean as the anchor, then a grey-world balance of the composite. Clipped
// pixels, reflections and standing objects count like all others. Pure functions.

#include <opencv2/core.hpp>
#include <span>

#include "algorithms/synthesis/overlap_statistics.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::accuracy {

/// Of four cameras around a vehicle, each pair of neighbours with at least one block.
synthesis::ToneMapping overlap_mean_gains(std::span<const synthesis::OverlapBlock> blocks);

/// The same gains, every channel times what makes the composite's channels equally bright. `means` are b, g,
/// r of the composite that the gains gave.
synthesis::ToneMapping grey_world(const synthesis::ToneMapping& gains, const cv::Scalar& means);

}  // namespace svchain::accuracy
