#pragma once
// All faults of a chain: where they strike, by the plan's links, edges and cores. Built with the chain;
// each part then belongs to its core.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "framework/fault/core_faults.h"
#include "framework/fault/recovery.h"

namespace svchain {

class ChainFaults {
 public:
  ChainFaults(FaultPlan plan, const Plan& chain, double fps);

  FaultSite& link(size_t index) { return links_[index]; }
  FaultSite& edge(size_t index) { return edges_[index]; }
  CoreFaults& core(size_t index) { return *cores_[index]; }
  Recovery& recovery() { return recovery_; }
  /// A fault of a kind is planned for the edge.
  bool any(FaultKind kind, size_t edge) const;

  /// Before the cores begin.
  void start(int64_t now_ns);
  /// The part "faults"; complete once the cores stand still.
  nlohmann::json report() const;

 private:
  void add(const PlannedFault& fault, FaultSite& site, int core);

  FaultPlan plan_;
  std::vector<FaultSite> links_, edges_;
  std::vector<std::unique_ptr<CoreFaults>> cores_;
  std::vector<std::unique_ptr<InjectedFault>> injected_;
  Recovery recovery_;
};

}  // namespace svchain
