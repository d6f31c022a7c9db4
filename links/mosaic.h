#pragma once
// Link "mosaic": two pictures side by side, for a display that shows two views of one capture.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_mosaic();

}  // namespace svchain
