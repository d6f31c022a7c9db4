#pragma once
// A bounded ring of messages between two links of one core: what ipc::Ring is between two cores, without
// anything that one thread does not need.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "ipc/message.h"

namespace svchain {

class LocalRing {
 public:
  explicit LocalRing(size_t capacity)
      : slots_(std::bit_ceil(std::max<size_t>(1, capacity))), mask_(slots_.size() - 1) {}

  /// Only where there is room: the edge sees to that.
  void push(const ipc::Message& message) { slots_[head_++ & mask_] = message; }
  /// The oldest message; null if there is none.
  const ipc::Message* front() const { return head_ == tail_ ? nullptr : &slots_[tail_ & mask_]; }
  void pop() { ++tail_; }
  size_t size() const { return head_ - tail_; }

 private:
  std::vector<ipc::Message> slots_;
  size_t mask_;
  size_t head_ = 0, tail_ = 0;
};

}  // namespace svchain
