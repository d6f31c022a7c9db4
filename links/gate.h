#pragma once
// Link "gate": lets frames through, or drops and counts them. Commands "open" and "close".

#include <memory>

#include "framework/link/link.h"

namespace svchain {

std::unique_ptr<Link> make_gate();

}  // namespace svchain
