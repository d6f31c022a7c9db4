#pragma once
// A bounded ring of fixed-size messages between one producer and one consumer, in memory that both map
// (threads or processes). Wait-free. Never allocates. What was pushed is read where it lies.
//
// The producer alone moves head, which publishes slots; the consumer alone moves tail, which gives them back.
// Either remembers how far it saw the other, and looks again only where that is not enough: the usual ring of
// queue libraries.
//
// The ring does not say when to wake the other side: see mark.h. For that, head and tail are written, and
// read, in one order that all see (seq_cst).
//
// Ownership: a Ring is a view; the memory belongs to whoever made it and must outlive every view. One view
// may serve both sides, but a side keeps to one view.

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "ipc/cache_line.h"

namespace svchain::ipc {

template <class T>
class Ring {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(std::atomic<uint64_t>::is_always_lock_free, "a lock does not work across processes");

  struct Control {
    alignas(kCacheLine) std::atomic<uint64_t> head{0};
    alignas(kCacheLine) std::atomic<uint64_t> tail{0};
    alignas(kCacheLine) uint64_t capacity = 0;
  };

 public:
  static size_t bytes(size_t capacity) {
    return rounded_to_cache_line(sizeof(Control) + slots(capacity) * sizeof(T));
  }
  /// Makes an empty ring in `memory` (aligned to a cache line, at least bytes(capacity)).
  static Ring create(void* memory, size_t capacity) {
    auto* control = new (memory) Control;
    control->capacity = capacity;
    new (control + 1) T[slots(capacity)];
    return Ring(control);
  }
  /// A view of a ring that another thread or process has made.
  static Ring attach(void* memory) { return Ring(static_cast<Control*>(memory)); }

  Ring() = default;

  // Producer:
  /// False if the ring is full.
  bool push(const T& message) {
    if (!stage(message)) return false;
    publish();
    return true;
  }
  /// Writes a message that the consumer does not see before publish(). False if the ring is full.
  bool stage(const T& message) {
    const uint64_t next = own_head() + staged_;
    if (!has_room(next)) return false;
    data_[next & mask_] = message;
    ++staged_;
    return true;
  }
  /// Hands over what was staged.
  void publish() {
    control_->head.store(own_head() + staged_, std::memory_order_seq_cst);
    staged_ = 0;
  }
  /// The messages staged, oldest first.
  template <class Do>
  void for_staged(Do&& with) {
    for (uint64_t i = 0; i < staged_; ++i) with(data_[(own_head() + i) & mask_]);
  }
  size_t staged() const { return staged_; }
  /// Messages on their way, staged ones too; at the least as many as there are.
  size_t filled_at_most() const { return own_head() + staged_ - tail_seen_; }
  size_t filled() {
    tail_seen_ = control_->tail.load(std::memory_order_seq_cst);
    return filled_at_most();
  }

  // Consumer:
  /// The oldest message, which stays there until pop(); null if the ring is empty.
  const T* front() {
    const uint64_t tail = control_->tail.load(std::memory_order_relaxed);
    if (tail == head_seen_) {
      head_seen_ = control_->head.load(std::memory_order_seq_cst);
      if (tail == head_seen_) return nullptr;
    }
    return &data_[tail & mask_];
  }
  /// Gives the slot of the front back.
  void pop() {
    control_->tail.store(control_->tail.load(std::memory_order_relaxed) + 1, std::memory_order_seq_cst);
  }
  /// front() and pop() in one. False if the ring is empty.
  bool pop(T& message) {
    const T* oldest = front();
    if (!oldest) return false;
    message = *oldest;
    pop();
    return true;
  }

  // Any:
  size_t size() const {
    const uint64_t tail = control_->tail.load(std::memory_order_seq_cst);
    return static_cast<size_t>(control_->head.load(std::memory_order_seq_cst) - tail);
  }
  bool empty() const { return size() == 0; }
  size_t capacity() const { return capacity_; }

 private:
  explicit Ring(Control* control)
      : control_(control),
        data_(reinterpret_cast<T*>(control + 1)),
        capacity_(control->capacity),
        mask_(slots(control->capacity) - 1),
        tail_seen_(control->tail.load(std::memory_order_acquire)),
        head_seen_(control->head.load(std::memory_order_acquire)) {}

  /// A power of two, so that no index needs a division.
  static size_t slots(size_t capacity) { return std::bit_ceil(std::max<size_t>(1, capacity)); }

  uint64_t own_head() const { return control_->head.load(std::memory_order_relaxed); }
  bool has_room(uint64_t next) {
    if (next - tail_seen_ < capacity_) return true;
    // what the slot's last reader did comes before what is written into it now
    tail_seen_ = control_->tail.load(std::memory_order_seq_cst);
    return next - tail_seen_ < capacity_;
  }

  Control* control_ = nullptr;
  T* data_ = nullptr;
  uint64_t capacity_ = 0, mask_ = 0;
  alignas(kCacheLine) uint64_t tail_seen_ = 0;  // the producer's
  uint64_t staged_ = 0;
  alignas(kCacheLine) uint64_t head_seen_ = 0;  // the consumer's
};

}  // namespace svchain::ipc
