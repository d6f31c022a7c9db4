#pragma once
// "Somebody waits for this": how one side of a ring learns that it has to wake the other. Lives in shared
// memory.
//
// Who finds nothing sets the mark, looks once more, and only then goes away. Who changes something publishes
// the change first and asks the mark after. The mark and what is looked at (the head of a ring, the tail) are
// written and read in one order that all see: either the second look finds the change, or the mark is found
// set, and its finder rings. So nobody who still has work pays for being rung, nor for being asked: the mark
// stays unwritten, and in both caches.

#include <atomic>
#include <cstdint>

#include "ipc/cache_line.h"

namespace svchain::ipc {

class alignas(kCacheLine) Mark {
 public:
  /// Who waits; it looks once more afterwards.
  void set() { set_.store(1, std::memory_order_seq_cst); }

  /// Who has changed something: true if somebody waits, who must now be rung. Takes the mark away.
  bool take() {
    if (set_.load(std::memory_order_seq_cst) == 0) return false;
    set_.store(0, std::memory_order_relaxed);  // before the ring, so that a look after it sets the mark anew
    return true;
  }

 private:
  std::atomic<uint32_t> set_{0};
};

static_assert(std::atomic<uint32_t>::is_always_lock_free);

}  // namespace svchain::ipc
