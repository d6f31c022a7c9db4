#pragma once
// The overlap statistics of synthesis without its picture, from some of the pixels: for photometric alignment
// where the picture is made in another way (3D), at a fraction of the cost. Any thread; allocates nothing.

#include <span>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/kernel.h"
#include "algorithms/synthesis/overlap_statistics.h"

namespace svchain::synthesis {

/// Fills `statistics` (room for the LUT's overlaps) from every `step`-th pixel of every overlap, at least one
/// of each. `frames` as for synthesize(). Throws std::invalid_argument for a step below 1, frames that are
/// not of the LUT's sizes, and too little room.
void sample_overlaps(const GeometricLut& lut, std::span<const colour::Picture> frames, int step,
                     OverlapStatistics& statistics, Kernel kernel);

}  // namespace svchain::synthesis
