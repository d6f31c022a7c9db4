#pragma once
// Paints convex patches onto the ground's texture with the exact area that a patch covers of each texel, so
// that an edge lies where it should to a fraction of a texel.

#include "algorithms/scene/scene.h"
#include "algorithms/scene/texture.h"

namespace svchain::scene {

/// Texel (column, row) is the square of side `metres_per_texel` whose middle is at
/// x = (column + 0.5) metres_per_texel - half_extent_m, y likewise by row.
void paint(Texture& ground, double metres_per_texel, double half_extent_m, const Patch& patch);

}  // namespace svchain::scene
