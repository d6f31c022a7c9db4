#pragma once
// Geometric alignment: on the first frames it makes the geometric and blending LUT of the rig, once, and
// hands it on; later frames it only lets go. (The paper's "Geometric alignment" at power-up.)

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_geometric_alignment();

}  // namespace svchain
