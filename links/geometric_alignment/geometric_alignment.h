#pragma once
// Geometric alignment (the paper's, at power-up): on the first complete set of frames it makes the geometric
// and blending LUT, once, and hands it on; later frames it only lets go. What the LUT is made from is its
// parameter "source": the rig as it is, a LUT that was stored, charts on the ground, or features of the
// overlaps.
//
// control("recalibrate") makes a new LUT from the next complete set. control("status") answers what the
// report says under "geometric_alignment". An alignment that is rejected stops the chain, unless a LUT is in
// force already: then that one stays.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_geometric_alignment();

}  // namespace svchain
