#pragma once
// Link "display": where pictures leave the chain: into a file, a folder, a window, or nowhere. Setting
// "output" (PATH, contracts: "The program"). Parameter `sha256`: the report names the hash of all delivered
// pixels.

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_display();

}  // namespace svchain
