#pragma once
// A shipped use case in which things break: run as a fault file would have it, with the accounts checked that
// have to balance whatever happens.

#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/surround_view.h"

namespace svchain::testing {

struct FaultyRun {
  std::string use_case = "2dsv_2dsp";
  nlohmann::json faults = nlohmann::json::array();  // entries of a fault file
  nlohmann::json random = nullptr;                  // or its part "random"
  double lasting_s = 14;
  double looked_at_s = 0;  // on threads: "delivered_since" of the report counts from then on
  bool pixels = false;     // in modelled time
  bool may_throw = true;   // every link's on_error is "drop"
  uint64_t seed = 1;
  std::vector<std::string> overrides = {};
};

/// In modelled time at 30 fps and, if nothing else is said, 880 x 1080 px without pixels. The report, with
/// "failure" where the chain failed.
nlohmann::json run_modelled(const SurroundView& world, const FaultyRun& run);
/// On threads at 30 fps, with pixels of a small view.
nlohmann::json run_on_threads(const SurroundView& world, const FaultyRun& run);

/// "" where every captured set was delivered or is counted by its reason, no buffer is missing, and no edge
/// held more than its depth.
std::string unbalanced(const nlohmann::json& report);

}  // namespace svchain::testing
