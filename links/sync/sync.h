#pragma once
// Link "sync": frames of four cameras that were taken at the same moment become sets of four (matching.h says
// which). A camera that is missing from a set is dealt with by the parameter `missing`: "repeat" puts in the
// newest frame that it has given (or leaves its place empty, if there was none), "skip" gives the set up
// until it is back.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_sync();

}  // namespace svchain
