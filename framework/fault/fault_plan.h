#pragma once
// Faults at the places of a plan: what a chain injects (core_faults.h). Plain values.

#include <cstdint>
#include <string>
#include <vector>

#include "framework/fault/fault_script.h"
#include "framework/usecase/plan.h"

namespace svchain {

struct PlannedFault {
  FaultKind kind = FaultKind::kDropout;
  /// An index into the plan's links (kSlow, kThrow, kNoMemory), cores (kHalt) or edges (the others); -1: the
  /// clock. A fault of what a source gives is one of the edge that leaves its output.
  int place = -1;
  std::string at;                  // the place as the report names it
  int64_t from_ns = 0, to_ns = 0;  // after the chain's start; to_ns is kNever where it lasts
  double chance = 1;
  int64_t amount_ns = 0;
  double factor = 1;

  static constexpr int64_t kNever = INT64_MAX / 4;
};

struct FaultPlan {
  std::vector<PlannedFault> faults;  // by beginning
  uint64_t seed = 1;                 // of what chance decides
};

/// Finds the places and draws the random faults, the same for the same seed and plan on every machine. An
/// entry names a link; a core or its role; an edge, in full or by its output alone. All names that are not in
/// the plan at once, each at its entry's place.
///
/// Random faults begin as a Poisson process. Kind, place, length and amount are drawn uniformly: chance 0.1
/// to 1, jitter 1 to 40 ms, wrong time stamps off by 1 ms to 10 s and clock steps of 1 ms to 2 s either way,
/// slow by a factor of 2 to 10, late by 1 to 200 ms. One that would last beyond the end is cut short. No link
/// whose policy is to stop throws at random: that would end the run.
Result<FaultPlan> place_faults(const FaultScript& script, const Plan& plan, uint64_t seed);

}  // namespace svchain
