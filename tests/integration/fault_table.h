#pragma once
// The runs behind the table in docs/faults.md, a line each.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace svchain::testing {

/// Faults last from here to a second later, where a line says nothing else, in runs of 14 s: power-up is over
/// after 5 s.
inline constexpr double kFaultsBegin_s = 8;

struct FaultLine {
  std::string name;                    // "FAULT at WHERE", as the line's first two cells have it
  std::vector<nlohmann::json> faults;  // entries of a fault file
  std::string drops_at = {};           // the link whose "on_error" is "drop"
  std::string use_case = "2dsv_2dsp";
  bool ends_the_run = false;
};

/// In the table's order.
const std::vector<FaultLine>& fault_lines();

}  // namespace svchain::testing
