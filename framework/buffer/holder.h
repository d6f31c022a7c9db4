#pragma once
// Who holds frames: one Holder per link. It knows the pools, keeps the accounts of who has what, and knows
// the way home for a buffer whose last reference goes on its core. Belongs to its link's core.

#include <memory>
#include <string>
#include <vector>

#include "framework/buffer/pool.h"
#include "ipc/doorbell.h"
#include "ipc/ring.h"

namespace svchain {

/// One bit per link of a core: something has changed for it, it should be looked at. Its core's thread only.
class Attention {
 public:
  explicit Attention(int runners = 0) : words_(static_cast<size_t>(runners + 63) / 64) {}
  void mark(int runner) { words_[static_cast<size_t>(runner) / 64] |= uint64_t{1} << (runner % 64); }
  void clear(int runner) { words_[static_cast<size_t>(runner) / 64] &= ~(uint64_t{1} << (runner % 64)); }
  const std::vector<uint64_t>& words() const { return words_; }

 private:
  std::vector<uint64_t> words_;
};

/// A buffer on its way back to its pool's owner.
struct ReturnedBuffer {
  ipc::BufferId buffer;
  uint32_t reserved = 0;
};
static_assert(sizeof(ReturnedBuffer) == 8);

/// The rings of returns that leave a core, one for every core that owns pools.
class ReturnPath {
 public:
  struct Way {
    ipc::Ring<ReturnedBuffer> ring;  // holds as many as the owner has buffers: never full
    ipc::Doorbell* doorbell = nullptr;
  };
  ReturnPath(int core, std::vector<Way> ways) : core_(core), ways_(std::move(ways)) {}
  void give_back(Pool& pool, uint16_t index);

 private:
  int core_;
  std::vector<Way> ways_;  // by core; none to itself
};

using PoolTable = std::vector<std::unique_ptr<Pool>>;

class Holder {
 public:
  Holder(size_t id, const PoolTable& pools, ReturnPath& returns)
      : id_(id), pools_(pools), returns_(returns) {}

  Pool& pool(ipc::BufferId buffer) const { return *pools_[buffer.pool]; }
  /// Accounts for a reference that has come to, or left, this holder; the reference itself goes on.
  void arrived(ipc::BufferId buffer) { pool(buffer).note_held(buffer.index, id_, 1); }
  void left(ipc::BufferId buffer) { pool(buffer).note_held(buffer.index, id_, -1); }
  void drop_reference(ipc::BufferId buffer);

 private:
  size_t id_;
  const PoolTable& pools_;
  ReturnPath& returns_;
};

}  // namespace svchain
