#include "framework/buffer/pool.h"

#include <algorithm>
#include <new>

namespace svchain {

namespace {

constexpr size_t kPage = 4096;
constexpr size_t kLine = 64;

size_t rounded(size_t bytes, size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

/// From one holder's counts to the next one's: no cache line has two of them, for holders are on different
/// cores.
size_t held_stride(size_t buffers) {
  return rounded(buffers * sizeof(std::atomic<uint16_t>), kLine) / sizeof(std::atomic<uint16_t>);
}

}  // namespace

Pool::Pool(uint16_t id, std::string name, Format format, size_t buffers, size_t holders, PoolOwner owner)
    : id_(id),
      name_(std::move(name)),
      format_(std::move(format)),
      owner_(owner),
      buffers_(buffers),
      stride_(rounded(std::max<size_t>(format_.bytes, 1), format_.bytes < kPage ? kLine : kPage)) {
  const size_t references_bytes = buffers * sizeof(References);
  const size_t held_bytes = held_stride(buffers) * holders * sizeof(std::atomic<uint16_t>);
  const size_t payload_at = rounded(references_bytes + held_bytes, kPage);
  region_ = ipc::SharedRegion("svchain:" + name_, payload_at + buffers * stride_);

  std::byte* memory = region_.bytes().data();
  references_ = new (memory) References[buffers];
  held_ = new (memory + references_bytes) std::atomic<uint16_t>[held_stride(buffers) * holders]();
  payload_ = memory + payload_at;

  free_.reserve(buffers);
  for (size_t i = buffers; i > 0; --i) free_.push_back(static_cast<uint16_t>(i - 1));
}

std::optional<uint16_t> Pool::take() {
  if (free_.empty()) return std::nullopt;
  const uint16_t index = free_.back();
  free_.pop_back();
  references_[index].count.store(1, std::memory_order_relaxed);
  high_water_ = std::max(high_water_, buffers_ - free_.size());
  return index;
}

void Pool::give_back(uint16_t index) {
  free_.push_back(index);
}

void Pool::note_held(uint16_t index, size_t holder, int change) {
  auto& held = held_[holder * held_stride(buffers_) + index];
  held.store(static_cast<uint16_t>(held.load(std::memory_order_relaxed) + change), std::memory_order_relaxed);
}

size_t Pool::held_by(size_t holder) const {
  size_t count = 0;
  for (size_t i = 0; i < buffers_; ++i) {
    count += held_[holder * held_stride(buffers_) + i].load(std::memory_order_relaxed) > 0 ? 1 : 0;
  }
  return count;
}

}  // namespace svchain
