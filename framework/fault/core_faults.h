#pragma once
// The faults of one core as time goes on: begins and ends those of the core, of its links and of the edges
// that leave them, and says when it wants to be asked again. Belongs to the core's thread once it runs.

#include <limits>
#include <optional>
#include <vector>

#include "framework/fault/fault_site.h"

namespace svchain {

class CoreFaults {
 public:
  /// The fault is in force at `site` from its begin to its end. Before the chain runs.
  void add(InjectedFault& fault, FaultSite& site);
  /// The chain starts now: what follows is in its time.
  void start(int64_t now_ns);

  /// Something may change at `now_ns`.
  bool due(int64_t now_ns) const { return now_ns >= next_ns_; }
  /// Begins and ends what is due. True where the core starts again after it has stood still.
  bool advance(int64_t now_ns);
  /// The time at which something changes next, if anything does.
  std::optional<int64_t> next_change_ns() const {
    return next_ns_ == kNever ? std::nullopt : std::optional(next_ns_);
  }
  /// An edge has a message that is due then.
  void look_again_at(int64_t time_ns) { next_ns_ = std::min(next_ns_, time_ns); }

  bool halted() const { return core_.in_force(FaultKind::kHalt) != nullptr; }
  /// Something stands still, and will go on by itself.
  bool hinders() const { return hindrances_ > 0; }
  /// By how much the links' clock is ahead of the chain's.
  int64_t clock_offset_ns() const { return clock_offset_ns_; }
  FaultSite& core() { return core_; }

 private:
  static constexpr int64_t kNever = std::numeric_limits<int64_t>::max();
  struct Change {
    int64_t at_ns;
    InjectedFault* fault;
    FaultSite* site;
    bool begins;
  };

  FaultSite core_;  // of the core itself, and of the clock as it sees it
  std::vector<Change> changes_;
  size_t next_ = 0;
  int64_t next_ns_ = kNever;
  int64_t clock_offset_ns_ = 0;
  int hindrances_ = 0;
};

}  // namespace svchain
