#pragma once
// How a core learns that something has changed for it: a counter that whoever changes something raises, and
// that the core waits on, first spinning, then parked on a futex. Lives in shared memory: works between
// threads and processes.
//
// The waiter reads the epoch, looks at everything it might do, and only if there is nothing waits for the
// epoch to move: a ring between the look and the wait is never lost. ring() costs a system call only when the
// waiter is parked, and then only the first: epoch and "somebody is parked" are one word, changed together.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace svchain::ipc {

class Doorbell {
 public:
  /// Any thread.
  void ring();

  uint32_t epoch() const { return word_.load(std::memory_order_acquire) & ~kParked; }

  /// The one waiter: returns when the epoch is no longer `seen`, or the timeout is over. Spins `spins` times
  /// before it parks; returns true if it had to park.
  bool wait(uint32_t seen, int spins, std::optional<std::chrono::nanoseconds> timeout);

 private:
  static constexpr uint32_t kParked = 1;
  static constexpr uint32_t kOneRing = 2;
  std::atomic<uint32_t> word_{0};
};

static_assert(std::atomic<uint32_t>::is_always_lock_free);

}  // namespace svchain::ipc
