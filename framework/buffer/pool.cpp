#include "framework/buffer/pool.h"

#include <algorithm>
#include <new>

namespace svchain {

namespace {

constexpr size_t kPage = 4096;

size_t rounded(size_t bytes, size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

/// From one holder's counts to the next one's: no cache line has two of them, for holders are on different
/// cores.
size_t held_stride(size_t buffers) {
  return ipc::rounded_to_cache_line(buffers * sizeof(std::atomic<uint16_t>)) / sizeof(std::atomic<uint16_t>);
}

}  // namespace

Pool::Pool(uint16_t id, std::string name, Format format, size_t buffers, size_t holders, PoolOwner owner)
    : id_(id),
      name_(std::move(name)),
      format_(std::move(format)),
      owner_(owner),
      buffers_(buffers),
      stride_(rounded(std::max<size_t>(format_.bytes, 1), format_.bytes < kPage ? ipc::kCacheLine : kPage)),
      held_stride_(held_stride(buffers)) {
  const size_t references_bytes = buffers * sizeof(References);
  const size_t held_bytes = held_stride_ * holders * sizeof(std::atomic<uint16_t>);
  const size_t payload_at = rounded(sizeof(ipc::Mark) + references_bytes + held_bytes, kPage);
  region_ = ipc::SharedRegion("svchain:" + name_, payload_at + buffers * stride_);

  std::byte* memory = region_.bytes().data();
  wanted_ = new (memory) ipc::Mark;
  memory += sizeof(ipc::Mark);
  references_ = new (memory) References[buffers];
  held_ = new (memory + references_bytes) std::atomic<uint16_t>[held_stride_ * holders]();
  payload_ = region_.bytes().data() + payload_at;

  free_.reserve(buffers);
  for (size_t i = buffers; i > 0; --i) free_.push_back(static_cast<uint16_t>(i - 1));
}

std::optional<uint16_t> Pool::take() {
  if (free_.empty()) return std::nullopt;
  const uint16_t index = free_.back();
  free_.pop_back();
  auto& count = references_[index].count;
  if (count.load(std::memory_order_relaxed) != 1) count.store(1, std::memory_order_relaxed);
  high_water_ = std::max(high_water_, buffers_ - free_.size());
  return index;
}

void Pool::give_back(uint16_t index) {
  free_.push_back(index);
}

size_t Pool::held_by(size_t holder) const {
  size_t count = 0;
  for (size_t i = 0; i < buffers_; ++i) {
    count += held_[holder * held_stride_ + i].load(std::memory_order_relaxed) > 0 ? 1 : 0;
  }
  return count;
}

}  // namespace svchain
