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
  bool drop_reference(uint16_t index) {
    return references_[index].count.fetch_sub(1, std::memory_order_acq_rel) == 1;
  }
  void note_held(uint16_t index, size_t holder, int change);

  std::span<std::byte> bytes(uint16_t index) const { return {payload_ + index * stride_, format_.bytes}; }

  size_t buffers() const { return buffers_; }
  size_t free() const { return free_.size(); }
  size_t high_water() const { return high_water_; }
  /// Buffers that `holder` holds. Exact once its core stands still.
  size_t held_by(size_t holder) const;

 private:
  /// A cache line each: neighbours are counted on different cores.
  struct alignas(64) References {
    std::atomic<uint32_t> count{0};
  };

  uint16_t id_;
  std::string name_;
  Format format_;
  PoolOwner owner_;
  size_t buffers_;
  size_t stride_;
  size_t high_water_ = 0;
  ipc::SharedRegion region_;
  References* references_ = nullptr;  // in the region, by index
  std::atomic<uint16_t>* held_ =
      nullptr;  // in the region, [holder][index]; each written by its holder's core only
  std::byte* payload_ = nullptr;
  std::vector<uint16_t> free_;
};

}  // namespace svchain
