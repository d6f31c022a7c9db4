#pragma once
// How many frames ended early, by reason. One writer; reasons are literals, so nothing is copied or
// allocated.

#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <string>

#include "framework/statistics/counter.h"

namespace svchain {

class DropCounts {
 public:
  void add(const char* reason, uint64_t n = 1) {
    for (auto& entry : entries_) {
      const char* known = entry.reason.load(std::memory_order_relaxed);
      if (known && std::strcmp(known, reason) != 0) continue;
      if (!known) entry.reason.store(reason, std::memory_order_release);
      entry.count.add(n);
      return;
    }
    others_.add(n);
  }
  uint64_t total() const;
  std::map<std::string, uint64_t> by_reason() const;

 private:
  struct Entry {
    std::atomic<const char*> reason{nullptr};
    Counter count;
  };
  std::array<Entry, 12> entries_;
  Counter others_;
};

}  // namespace svchain
