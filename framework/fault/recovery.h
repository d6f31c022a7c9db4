#pragma once
// How soon a chain is back to its full rate when faults are over. At full rate no two deliveries are more
// than one and a half periods apart; a gap that ends after all faults of a time have ended, and before the
// next begins, is put down to them. Written by the delivering link's core, read when that stands still.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "framework/fault/fault_plan.h"

namespace svchain {

class Recovery {
 public:
  Recovery(const std::vector<PlannedFault>& faults, double fps);

  void start(int64_t now_ns);
  void delivered(int64_t now_ns);

  /// {"slowest_s", "after_s": when those faults were over}; slowest_s is 0 where none left a gap behind.
  nlohmann::json report() const;

 private:
  /// Faults without a pause between them.
  struct Trouble {
    int64_t from_ns, to_ns;
  };

  std::vector<Trouble> troubles_;  // by time
  size_t next_ = 0;                // the first that has not begun
  int64_t longest_gap_ns_;
  int64_t start_ns_ = 0, last_ns_ = 0;
  int64_t slowest_ns_ = 0, slowest_after_ns_ = 0;
};

}  // namespace svchain
