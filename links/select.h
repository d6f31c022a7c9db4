#pragma once
// Link "select": some of the buffers of a set, in the order given.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_select();

}  // namespace svchain
