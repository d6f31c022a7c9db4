#pragma once
// The one list of links and settings that come with the program.

#include "framework/link/catalogue.h"

namespace svchain {

void add_builtin_links(Catalogue& catalogue);

}  // namespace svchain
