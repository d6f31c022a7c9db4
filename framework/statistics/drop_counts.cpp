#include "framework/statistics/drop_counts.h"

namespace svchain {

uint64_t DropCounts::total() const {
  uint64_t sum = 0;
  for (const auto& [reason, count] : by_reason()) sum += count;
  return sum;
}

std::map<std::string, uint64_t> DropCounts::by_reason() const {
  std::map<std::string, uint64_t> counts;
  for (const auto& entry : entries_) {
    const char* reason = entry.reason.load(std::memory_order_acquire);
    if (reason && entry.count.value() > 0) counts[reason] = entry.count.value();
  }
  if (others_.value() > 0) counts["other"] = others_.value();
  return counts;
}

}  // namespace svchain
