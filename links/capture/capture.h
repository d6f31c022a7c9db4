#pragma once
// Link "capture": the four cameras. Outputs front, right, rear, left, each bgr8, or what
// the parameters "format" and "colour" ask for. Settings "input" (SOURCE,
// contracts: "The program") and "rig" (its image sizes have to be the source's; may be "").

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_capture();

}  // namespace svchain
