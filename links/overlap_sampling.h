#pragma once
// Link "overlap_sampling": the overlap statistics that photometric alignment goes by, from some pixels of
// every overlap, where no synthesis makes them on the way (algorithms/synthesis/overlap_sampling.h).

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_overlap_sampling();

}  // namespace svchain
