#pragma once
// How long round trips took: the moment of every departure is noted, what lies between two is one trip. One
// thread.

#include <chrono>
#include <cstdint>
#include <vector>

#include "usecases/svchain_bench/paired.h"

namespace svchain::bench {

inline int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

class RoundTrips {
 public:
  explicit RoundTrips(int trips) { departures_ns_.reserve(static_cast<size_t>(trips) + 1); }
  void depart() { departures_ns_.push_back(now_ns()); }

  /// Trips measured: one less than departures.
  size_t count() const { return departures_ns_.empty() ? 0 : departures_ns_.size() - 1; }
  double quantile_ns(double share) const {
    std::vector<double> trips;
    for (size_t i = 1; i < departures_ns_.size(); ++i)
      trips.push_back(static_cast<double>(departures_ns_[i] - departures_ns_[i - 1]));
    return quantile(std::move(trips), share);
  }

 private:
  std::vector<int64_t> departures_ns_;
};

}  // namespace svchain::bench
