#pragma once
// How a core learns that something has changed for it: bells that whoever changes something rings, and that
// the core waits for, first spinning, then parked on a futex. Lives in shared memory: works between threads
// and processes.
//
// A bell once rung stays rung until the waiter takes it. The waiter takes the bells, looks at what they stand
// for, and only if there is nothing waits for the next: a ring between the look and the wait is never lost.
// ring() costs a system call only when the waiter is parked, and then only the first: the bells and "somebody
// is parked" are one word, changed together.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

#include "ipc/pause.h"

namespace svchain::ipc {

class Doorbell {
 public:
  static constexpr int kBells = 31;

  /// Any thread. `bell`: 0 to kBells - 1.
  void ring(int bell = 0);

  // The one waiter:
  /// The bells rung since it asked last, bit n for bell n.
  uint32_t take() {
    if (!rung()) return 0;  // nothing is written while nobody rings
    return word_.fetch_and(kParked, std::memory_order_acq_rel) >> 1;
  }
  /// Looks up to `spins` times whether a bell has been rung, or whether arrived() says that something has
  /// come all the same. True if so.
  template <class Arrived>
  bool spin(int spins, const Arrived& arrived) const {
    for (int i = 0; i < spins; ++i) {
      if (rung() || arrived()) return true;
      pause();
    }
    return false;
  }
  /// Returns when a bell has been rung or the timeout is over. True if it had to park.
  bool park(std::optional<std::chrono::nanoseconds> timeout = std::nullopt);

 private:
  bool rung() const { return (word_.load(std::memory_order_acquire) & ~kParked) != 0; }

  static constexpr uint32_t kParked = 1;
  std::atomic<uint32_t> word_{0};
};

static_assert(std::atomic<uint32_t>::is_always_lock_free);

}  // namespace svchain::ipc
