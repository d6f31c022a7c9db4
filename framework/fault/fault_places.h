#pragma once
// Where in a plan each kind of fault can strike, and what such a place is called. Internal.

#include <string>
#include <vector>

#include "framework/fault/fault_script.h"
#include "framework/usecase/plan.h"

namespace svchain {

struct FaultPlace {
  int index = -1;                        // as in PlannedFault::place
  std::string name;                      // as reports show it
  std::vector<std::string> other_names;  // that an entry may say as well
};

/// In the plan's order. The clock is one place, and always there.
std::vector<FaultPlace> places_of(FaultKind kind, const Plan& plan);

/// "a link", "an edge", ...: what an entry of this kind has to name.
const char* kind_of_place(FaultKind kind);

}  // namespace svchain
