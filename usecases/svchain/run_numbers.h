#pragma once
// The numbers among the options of a run.

#include "algorithms/json/fault.h"
#include "framework/link/link.h"
#include "usecases/svchain/commands.h"

namespace svchain::program {

struct RunNumbers {
  Pace pace;                           // as far as the options say
  std::optional<double> fps;           // --fps: in real time, at this rate
  std::optional<uint64_t> order_seed;  // --seed: the order in which a virtual run steps its cores
};

/// Bad ones become faults.
RunNumbers read_numbers(const RunOptions& options, Faults& faults);

}  // namespace svchain::program
