#pragma once
// Link "null": takes frames and does nothing with them.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_null();

}  // namespace svchain
