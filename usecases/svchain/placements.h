#pragma once
// All ways to place a use case's algorithms on a SoC, and how one of them does in modelled time. What the
// file puts on a DSP or an EVE (but for dup, which only hands on) may be on any DSP, and on an EVE where the
// SoC's cost model has a figure for it; what it puts on the SGX, on an SGX only. Everything else stays.

#include <string>
#include <vector>

#include "framework/usecase/plan.h"

namespace svchain::program {

/// A link and the core it is on.
struct Placed {
  std::string link, core;
};
using Placement = std::vector<Placed>;

/// Of the links that may be moved, in the use case's order. Empty where the SoC has no place for one of its
/// links. `home`: the SoC the use case was written for.
std::vector<Placement> placements(const UseCase& use_case, const Soc& home, const Soc& soc);

struct Judgement {
  std::string soc;
  Placement placement;
  bool holds = false;  // no set is dropped after power-up
  double fps = 0;      // after power-up, as all below
  double load = 0;     // of the fullest core
  std::string fullest;
  double latency_p99_ms = 0;
  int moved = 0;  // links that are elsewhere than in the file
};

/// Runs it without pixels at this rate, through power-up and a minute of modelled time. Throws
/// std::runtime_error where the chain cannot be run so. Any thread.
Judgement judge(UseCase use_case, const Soc& soc, const Catalogue& catalogue, const Placement& placement,
                double fps);

/// Those that hold first, then by the load of the fullest core, then by latency, then the least moved.
bool is_better(const Judgement& a, const Judgement& b);

}  // namespace svchain::program
