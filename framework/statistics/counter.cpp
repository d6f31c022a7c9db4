#include "framework/statistics/counter.h"

#include <algorithm>
#include <cmath>

namespace svchain {

int64_t Histogram::quantile_ns(double q) const {
  const uint64_t total = count();
  if (total == 0) return 0;
  const auto wanted = std::max<uint64_t>(1, static_cast<uint64_t>(std::ceil(q * static_cast<double>(total))));
  uint64_t seen = 0;
  for (size_t i = 0; i < kBuckets; ++i) {
    seen += buckets_[i].value();
    if (seen >= wanted) return std::min<int64_t>(max_ns(), static_cast<int64_t>(upper_edge(i)));
  }
  return max_ns();
}

}  // namespace svchain
