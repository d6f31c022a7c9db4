#pragma once
// Asks for what a block reads of the cameras' frames, so that it is in the cache when the block's turn comes.
// Changes nothing; any thread.

#include <span>

#include "algorithms/colour/picture.h"
#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

void prefetch(const GeometricLut& lut, const LutBlock& block, std::span<const colour::Picture> frames);

}  // namespace svchain::synthesis
