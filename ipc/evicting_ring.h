#pragma once
// The ring of an edge that may drop: like ring.h, but the producer may take the oldest message out again.
// Lock-free, wait-free but for pop() against a concurrent pop() of the other side. Never allocates.
//
// The producer alone moves head, which publishes a slot. The consumer moves tail; so does the producer when
// it evicts the oldest message of a full ring, hence tail is moved by compare-exchange and a reader that lost
// the race throws its copy away. Slots are read and written as relaxed atomic words, so that such a lost copy
// is no data race. Head and tail are written, and read, in one order that all see: see mark.h.
//
// Ownership: a view; the memory belongs to whoever made it and must outlive every view.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

#include "ipc/cache_line.h"

namespace svchain::ipc {

template <class T>
class EvictingRing {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(uint64_t) == 0);
  static_assert(std::atomic<uint64_t>::is_always_lock_free, "a lock does not work across processes");
  static constexpr size_t kWords = sizeof(T) / sizeof(uint64_t);

  struct Slot {
    std::array<std::atomic<uint64_t>, kWords> words;
  };
  struct Control {
    alignas(kCacheLine) std::atomic<uint64_t> head{0};
    alignas(kCacheLine) std::atomic<uint64_t> tail{0};
    alignas(kCacheLine) uint64_t capacity = 0;
  };

 public:
  static size_t bytes(size_t capacity) {
    return rounded_to_cache_line(sizeof(Control) + capacity * sizeof(Slot));
  }
  /// Makes an empty ring in `memory` (aligned to a cache line, at least bytes(capacity)).
  static EvictingRing create(void* memory, size_t capacity) {
    auto* control = new (memory) Control;
    control->capacity = capacity;
    new (control + 1) Slot[capacity];
    return EvictingRing(control);
  }
  /// A view of a ring that another thread or process has made.
  static EvictingRing attach(void* memory) { return EvictingRing(static_cast<Control*>(memory)); }

  EvictingRing() = default;

  /// Producer. False if the ring is full.
  bool push(const T& message) {
    const uint64_t head = control_->head.load(std::memory_order_relaxed);
    // acquire: the slot's last reader must be done before it is written again
    if (head - control_->tail.load(std::memory_order_acquire) >= control_->capacity) return false;
    write(slots_[head % control_->capacity], message);
    control_->head.store(head + 1, std::memory_order_seq_cst);  // publishes the slot
    return true;
  }

  /// Consumer (or the producer, who so evicts the oldest). False if the ring is empty.
  bool pop(T& message) {
    uint64_t tail = control_->tail.load(std::memory_order_acquire);
    while (tail != control_->head.load(std::memory_order_seq_cst)) {
      read(slots_[tail % control_->capacity], message);
      // the copy is finished before the slot is given back
      if (control_->tail.compare_exchange_weak(tail, tail + 1, std::memory_order_seq_cst,
                                               std::memory_order_acquire)) {
        return true;
      }
    }
    return false;
  }

  size_t size() const {
    const uint64_t tail = control_->tail.load(std::memory_order_seq_cst);
    return static_cast<size_t>(control_->head.load(std::memory_order_seq_cst) - tail);
  }
  bool empty() const { return size() == 0; }
  size_t capacity() const { return control_->capacity; }

 private:
  explicit EvictingRing(Control* control) : control_(control), slots_(reinterpret_cast<Slot*>(control + 1)) {}

  static void write(Slot& slot, const T& message) {
    std::array<uint64_t, kWords> words;
    std::memcpy(words.data(), &message, sizeof(T));
    for (size_t i = 0; i < kWords; ++i) slot.words[i].store(words[i], std::memory_order_relaxed);
  }
  static void read(const Slot& slot, T& message) {
    std::array<uint64_t, kWords> words;
    for (size_t i = 0; i < kWords; ++i) words[i] = slot.words[i].load(std::memory_order_relaxed);
    std::memcpy(static_cast<void*>(&message), words.data(), sizeof(T));
  }

  Control* control_ = nullptr;
  Slot* slots_ = nullptr;
};

}  // namespace svchain::ipc
