#pragma once
// Checks on faults and short ways to a use case.

#include <string>
#include <vector>

#include "algorithms/json/fault.h"
#include "framework/usecase/plan.h"

namespace svchain::testing {

/// Fails unless one fault stands at `place` ("t.json:3:14: error: /links/x/core", or "" for any) and says all
/// `words`.
void check_fault(const Faults& faults, const std::string& place, const std::vector<std::string>& words);

/// A use case for the SoC tda2x, one link a line from line 2 on, then an empty line, then one edge a line.
std::string text_of(const std::vector<std::string>& links, const std::vector<std::string>& edges);

/// The cores of tda2x as far as tests need them: A15 (host), IPU1, DSP1, DSP2.
Soc small_soc();

/// Plans a use case of the fake links; its reading must succeed.
Result<Plan> plan_of(const std::string& text);
/// The faults of planning it.
Faults plan_faults(const std::string& text);

/// The use case of two DSPs, as users write it.
extern const std::string kTwoDsps;

}  // namespace svchain::testing
