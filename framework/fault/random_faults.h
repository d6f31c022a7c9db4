#pragma once
// Faults that a seed draws: beginnings as a Poisson process, each fault's kind, place, length and amount
// uniformly. The ranges: fault_plan.h. Internal.

#include "framework/fault/fault_plan.h"

namespace svchain {

/// By beginning. A kind that has no place in the plan is not drawn; where none has one, that is a fault.
Result<std::vector<PlannedFault>> draw_faults(const RandomFaults& random, const Plan& plan, uint64_t seed);

}  // namespace svchain
