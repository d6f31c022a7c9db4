#include "framework/buffer/holder.h"

namespace svchain {

void Holder::drop_reference(ipc::BufferId buffer) {
  Pool& owner = pool(buffer);
  owner.note_held(buffer.index, id_, -1);
  if (owner.drop_reference(buffer.index)) returns_.give_back(owner, buffer.index);
}

bool Holder::has_free(Pool& pool) const {
  if (pool.free() > pool.never_used()) return true;
  returns_.collect(pools_);
  if (pool.free() > 0) return true;
  pool.wanted().set();
  returns_.collect(pools_);
  return pool.free() > 0;
}

}  // namespace svchain
