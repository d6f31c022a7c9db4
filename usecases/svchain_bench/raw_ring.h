#pragma once
// What a hop between two threads costs at the least: a ring for one producer and one consumer with nothing
// around it. Its ends spin, or park on a futex at once. Both remember how far the other was, so that they
// seldom look (the usual ring of queue libraries). Carries what our own hops carry, so that the same bytes
// are moved.

#include <atomic>
#include <cstdint>
#include <vector>

#include "ipc/message.h"

namespace svchain::bench {

class RawRing {
 public:
  /// A power of two.
  explicit RawRing(size_t capacity) : slots_(capacity), mask_(capacity - 1) {}

  /// Producer.
  bool push(const ipc::Message& message) {
    const uint64_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_seen_ > mask_) {
      tail_seen_ = tail_.load(std::memory_order_acquire);
      if (head - tail_seen_ > mask_) return false;
    }
    slots_[head & mask_] = message;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }
  /// Consumer.
  bool pop(ipc::Message& message) {
    const uint64_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_seen_) {
      head_seen_ = head_.load(std::memory_order_acquire);
      if (tail == head_seen_) return false;
    }
    message = slots_[tail & mask_];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

 private:
  std::vector<ipc::Message> slots_;
  uint64_t mask_;
  alignas(128) std::atomic<uint64_t> head_{0};
  uint64_t tail_seen_ = 0;  // the producer's
  alignas(128) std::atomic<uint64_t> tail_{0};
  uint64_t head_seen_ = 0;  // the consumer's
};

}  // namespace svchain::bench
