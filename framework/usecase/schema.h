#pragma once
// The JSON Schema (draft 2020-12) of use case files, made from what a catalogue holds: every link type with
// its parameters, their ranges, units and choices, and every setting.

#include <string>

#include "framework/link/catalogue.h"

namespace svchain {

std::string use_case_schema(const Catalogue& catalogue);

}  // namespace svchain
