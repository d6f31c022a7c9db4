#pragma once
// Link "null_source": synthetic frames (bgr8) for chains without cameras, written once and sent again and
// again, at the pace of a capture.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_null_source();

}  // namespace svchain
