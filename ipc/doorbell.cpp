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

}  // namespace

void Doorbell::ring(int bell) {
  if ((word_.fetch_or(kParked << 1 << bell, std::memory_order_acq_rel) & kParked) == 0) return;
  // Those who ring from here on may leave it to this call to wake the waiter.
  word_.fetch_and(~kParked, std::memory_order_relaxed);
  futex_wake(word_);
}

bool Doorbell::park(std::optional<std::chrono::nanoseconds> timeout) {
  if (timeout && timeout->count() <= 0) return false;
  uint32_t silent = 0;
  if (!word_.compare_exchange_strong(silent, kParked, std::memory_order_acq_rel, std::memory_order_acquire))
    return false;
  timespec limit{};
  if (timeout) {
    limit.tv_sec = static_cast<time_t>(timeout->count() / 1'000'000'000);
    limit.tv_nsec = static_cast<long>(timeout->count() % 1'000'000'000);
  }
  // Returns at once where the word has changed since, be it only that a ringer took the mark away.
  futex_wait(word_, kParked, timeout ? &limit : nullptr);
  word_.fetch_and(~kParked, std::memory_order_relaxed);
  return true;
}

}  // namespace svchain::ipc
