#include "ipc/doorbell.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

namespace svchain::ipc {

namespace {

// Not the private kind of futex: the word may be mapped into several processes.
void futex_wake(std::atomic<uint32_t>& word) {
  syscall(SYS_futex, reinterpret_cast<uint32_t*>(&word), FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

void futex_wait(std::atomic<uint32_t>& word, uint32_t seen, const timespec* timeout) {
  syscall(SYS_futex, reinterpret_cast<uint32_t*>(&word), FUTEX_WAIT, seen, timeout, nullptr, 0);
}

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

void Doorbell::ring() {
  // Sequentially consistent on both sides (here: epoch, then parked; in wait: parked, then epoch): either the
  // waiter sees the new epoch, or the ringer sees that it is parked.
  epoch_.fetch_add(1, std::memory_order_seq_cst);
  if (parked_.load(std::memory_order_seq_cst) != 0) futex_wake(epoch_);
}

bool Doorbell::wait(uint32_t seen, int spins, std::optional<std::chrono::nanoseconds> timeout) {
  for (int i = 0; i < spins; ++i) {
    if (epoch_.load(std::memory_order_acquire) != seen) return false;
    pause();
  }
  if (timeout && timeout->count() <= 0) return false;
  parked_.store(1, std::memory_order_seq_cst);
  const bool parks = epoch_.load(std::memory_order_seq_cst) == seen;
  if (parks) {
    timespec limit{};
    if (timeout) {
      limit.tv_sec = static_cast<time_t>(timeout->count() / 1'000'000'000);
      limit.tv_nsec = static_cast<long>(timeout->count() % 1'000'000'000);
    }
    futex_wait(epoch_, seen, timeout ? &limit : nullptr);
  }
  parked_.store(0, std::memory_order_relaxed);
  return parks;
}

}  // namespace svchain::ipc
