#include "framework/fault/recovery.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace svchain {

Recovery::Recovery(const std::vector<PlannedFault>& faults, double fps)
    : longest_gap_ns_(static_cast<int64_t>(1.5e9 / fps)) {
  for (const PlannedFault& fault : faults) {  // by beginning
    if (troubles_.empty() || fault.from_ns > troubles_.back().to_ns) {
      troubles_.push_back({fault.from_ns, fault.to_ns});
    } else {
      troubles_.back().to_ns = std::max(troubles_.back().to_ns, fault.to_ns);
    }
  }
}

void Recovery::start(int64_t now_ns) {
  start_ns_ = last_ns_ = now_ns;
}

void Recovery::delivered(int64_t now_ns) {
  const int64_t since_start_ns = now_ns - start_ns_;
  while (next_ < troubles_.size() && troubles_[next_].from_ns <= since_start_ns) ++next_;
  const int64_t gap_ns = now_ns - last_ns_;
  last_ns_ = now_ns;
  if (next_ == 0 || gap_ns <= longest_gap_ns_) return;
  const int64_t over_ns = troubles_[next_ - 1].to_ns;
  if (since_start_ns - over_ns <= slowest_ns_) return;
  slowest_ns_ = since_start_ns - over_ns;
  slowest_after_ns_ = over_ns;
}

nlohmann::json Recovery::report() const {
  const auto seconds = [](int64_t ns) { return static_cast<double>(ns / 1000) / 1e6; };
  return {{"slowest_s", seconds(slowest_ns_)}, {"after_s", seconds(slowest_after_ns_)}};
}

}  // namespace svchain
