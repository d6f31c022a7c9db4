#pragma once
// Photometric alignment: from the overlaps of frame n, the tone mapping of frame n + 1. (The paper's
// "Photometric alignment".)

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_photometric_alignment();

}  // namespace svchain
