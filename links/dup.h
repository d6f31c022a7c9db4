#pragma once
// Link "dup": hands the same frames to up to six outputs; pixels are never copied.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_dup();

}  // namespace svchain
