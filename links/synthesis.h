#pragma once
// Synthesis: the composite of a set of four, in one pass through the LUTs, and the statistics of its
// overlaps. (The paper's "Surround view synthesis".)

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_synthesis();

}  // namespace svchain
