#pragma once
// Frames that a link keeps for later calls, oldest first. Room is made once: pushing and popping allocate
// nothing. Belongs to its link's core.

#include <cassert>
#include <utility>
#include <vector>

#include "framework/buffer/frame.h"

namespace svchain {

class FrameQueue {
 public:
  explicit FrameQueue(size_t capacity = 0) : frames_(capacity) {}

  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == frames_.size(); }
  size_t size() const { return size_; }
  /// 0 is the oldest.
  const Frame& operator[](size_t i) const {
    assert(i < size_);
    return frames_[(first_ + i) % frames_.size()];
  }
  const Frame& front() const { return (*this)[0]; }
  const Frame& back() const { return (*this)[size_ - 1]; }

  void push(Frame&& frame) {
    assert(!full());
    frames_[(first_ + size_) % frames_.size()] = std::move(frame);
    ++size_;
  }
  Frame pop() {
    assert(!empty());
    Frame frame = std::move(frames_[first_]);
    first_ = (first_ + 1) % frames_.size();
    --size_;
    return frame;
  }
  void clear() {
    while (!empty()) pop();
  }

 private:
  std::vector<Frame> frames_;
  size_t first_ = 0;
  size_t size_ = 0;
};

}  // namespace svchain
