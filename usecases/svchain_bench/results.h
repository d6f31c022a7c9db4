#pragma once
// What `svchain_bench --ratios FILE.json` writes (contracts: "Building"): medians of paired ratios, and
// figures, every one of the contract's names among them; null for what this machine lacks. Plain values.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "usecases/svchain_bench/paired.h"

namespace svchain::bench {

struct Results {
  std::map<std::string, Paired> ratios;
  std::map<std::string, double> figures;
  std::map<std::string, std::string> missing;  // why a ratio is not there: "not installed"
};

/// Where it was measured.
struct Machine {
  std::string processor, compiler, opencv;
};
Machine this_machine();

/// Beside "ratios" and "figures" there are "quartiles" of the ratios and "costs", the medians of both sides.
nlohmann::json json_of(const Results& results, const Machine& machine);

}  // namespace svchain::bench
