#pragma once
// A place where faults strike: a link, an edge, a core. Knows which are in force; whoever works there asks.
// Belongs to the place's core (an edge to its producer's). Nothing here allocates while a chain runs.

#include <algorithm>
#include <vector>

#include "framework/fault/fault_plan.h"
#include "framework/statistics/counter.h"

namespace svchain {

/// A planned fault in a run, and how often it has struck.
struct InjectedFault {
  const PlannedFault* planned = nullptr;
  uint64_t seed = 0;
  Counter times;
};

class FaultSite {
 public:
  /// For so many faults at once.
  void reserve(size_t faults) { in_force_.reserve(faults); }
  void begin(InjectedFault& fault) { in_force_.push_back(&fault); }
  void end(InjectedFault& fault) { std::erase(in_force_, &fault); }

  /// The fault of a kind that began last, if one is in force.
  const PlannedFault* in_force(FaultKind kind) const {
    const InjectedFault* fault = newest(kind);
    return fault ? fault->planned : nullptr;
  }
  /// The same, counted; null where chance spares this `occasion` (the frame, the message, the call). What
  /// chance says depends on nothing but the seed, the fault and the occasion.
  const PlannedFault* strike(FaultKind kind, uint64_t occasion);

 private:
  InjectedFault* newest(FaultKind kind) const {
    for (size_t i = in_force_.size(); i-- > 0;) {
      if (in_force_[i]->planned->kind == kind) return in_force_[i];
    }
    return nullptr;
  }

  std::vector<InjectedFault*> in_force_;
};

/// A number from 0 to 1 that looks random, the same on every machine.
double chance_of(uint64_t seed, uint64_t occasion);

}  // namespace svchain
