#pragma once
// A pool of equal buffers in shared memory, referred to by index. Every buffer counts its references, and
// beside that how many each holder has, so that at the end it can be said who keeps what.
//
// Thread rule: take() and give_back() belong to the owner's core. References are counted from any core;
// whoever drops the last one sees to it that the index gets back to the owner (ReturnPath).

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/buffer/format.h"
#include "ipc/mark.h"
#include "ipc/message.h"
#include "ipc/shared_region.h"

namespace svchain {

class Attention;

struct PoolOwner {
  int core = 0;
  Attention* attention = nullptr;  // told when a buffer comes back
  int runner = 0;
};

class Pool {
 public:
  /// Throws std::system_error where memory is short.
  Pool(uint16_t id, std::string name, Format format, size_t buffers, size_t holders, PoolOwner owner);

  uint16_t id() const { return id_; }
  const std::string& name() const { return name_; }
  const Format& format() const { return format_; }
  const PoolOwner& owner() const { return owner_; }

  /// A free buffer with one reference, the most recently returned first (it is still in the cache).
  std::optional<uint16_t> take();
  void give_back(uint16_t index);

  void add_reference(uint16_t index) { references_[index].count.fetch_add(1, std::memory_order_relaxed); }
  /// True for the last one. acq_rel: every holder's reads come before the next writer's writes.
  /// Who finds itself alone need not write, and a buffer that has one holder at a time is never written here.
  bool drop_reference(uint16_t index) {
    if (references_[index].count.load(std::memory_order_acquire) == 1) return true;
    return references_[index].count.fetch_sub(1, std::memory_order_acq_rel) == 1;
  }
  void note_held(uint16_t index, size_t holder, int change) {
    auto& held = held_[holder * held_stride_ + index];
    held.store(static_cast<uint16_t>(held.load(std::memory_order_relaxed) + change),
               std::memory_order_relaxed);
  }
  /// The owner has no buffer and waits for one.
  ipc::Mark& wanted() const { return *wanted_; }

  std::span<std::byte> bytes(uint16_t index) const { return {payload_ + index * stride_, format_.bytes}; }

  size_t buffers() const { return buffers_; }
  size_t free() const { return free_.size(); }
  size_t high_water() const { return high_water_; }
  /// Buffers that have never been out while all others were.
  size_t never_used() const { return buffers_ - high_water_; }
  /// Buffers that `holder` holds. Exact once its core stands still.
  size_t held_by(size_t holder) const;

 private:
  /// A cache line each: neighbours are counted on different cores.
  struct alignas(ipc::kCacheLine) References {
    std::atomic<uint32_t> count{1};  // of a free buffer: what it will begin with, unless two left it at once
  };

  uint16_t id_;
  std::string name_;
  Format format_;
  PoolOwner owner_;
  size_t buffers_;
  size_t stride_;
  size_t held_stride_;
  ipc::SharedRegion region_;
  ipc::Mark* wanted_ = nullptr;       // in the region
  References* references_ = nullptr;  // in the region, by index
  std::atomic<uint16_t>* held_ =
      nullptr;  // in the region, [holder][index]; each written by its holder's core only
  std::byte* payload_ = nullptr;
  // The owner's, who changes them all the time, apart from what all cores read.
  alignas(ipc::kCacheLine) std::vector<uint16_t> free_;
  size_t high_water_ = 0;
};

}  // namespace svchain
