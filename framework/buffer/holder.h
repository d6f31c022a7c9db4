#pragma once
// Who holds frames: one Holder per link. It knows the pools, keeps the accounts of who has what, and knows
// the way home for a buffer whose last reference goes on its core. Belongs to its link's core.

#include <optional>

#include "framework/buffer/pool.h"
#include "framework/buffer/return_path.h"

namespace svchain {

class Holder {
 public:
  Holder(size_t id, const PoolTable& pools, ReturnPath& returns)
      : id_(id), pools_(pools), returns_(returns) {}

  Pool& pool(ipc::BufferId buffer) const { return *pools_[buffer.pool]; }
  /// Accounts for a reference that has come to, or left, this holder; the reference itself goes on.
  void arrived(ipc::BufferId buffer) { pool(buffer).note_held(buffer.index, id_, 1); }
  void left(ipc::BufferId buffer) { pool(buffer).note_held(buffer.index, id_, -1); }
  void drop_reference(ipc::BufferId buffer);

  /// Whether a pool of this core has a free buffer, be it one that has just come home. If not, the core is
  /// rung when one does.
  bool has_free(Pool& pool) const;

 private:
  size_t id_;
  const PoolTable& pools_;
  ReturnPath& returns_;
};

}  // namespace svchain
