#include "framework/buffer/holder.h"

namespace svchain {

void ReturnPath::give_back(Pool& pool, uint16_t index) {
  const PoolOwner& owner = pool.owner();
  if (owner.core == core_) {
    pool.give_back(index);
    owner.attention->mark(owner.runner);
    return;
  }
  Way& way = ways_[static_cast<size_t>(owner.core)];
  way.ring.push({{pool.id(), index}});
  if (way.ring.size() <= 1) way.doorbell->ring();  // else it has been told, and not yet looked
}

void Holder::drop_reference(ipc::BufferId buffer) {
  left(buffer);
  Pool& owner = pool(buffer);
  if (owner.drop_reference(buffer.index)) returns_.give_back(owner, buffer.index);
}

}  // namespace svchain
