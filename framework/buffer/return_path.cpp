#include "framework/buffer/return_path.h"

#include "framework/buffer/attention.h"

namespace svchain {

void ReturnPath::add_way(int owner, const Way& way) {
  const auto at = static_cast<size_t>(owner);
  if (ways_.size() <= at) ways_.resize(at + 1);
  ways_[at] = way;
}

void ReturnPath::give_back(Pool& pool, uint16_t index) {
  const PoolOwner& owner = pool.owner();
  if (owner.core == core_) {
    pool.give_back(index);
    owner.attention->mark(owner.runner);
    return;
  }
  Way& way = ways_[static_cast<size_t>(owner.core)];
  way.ring.push({{pool.id(), index}});
  if (pool.wanted().take()) way.doorbell->ring(bell_of(owner.runner));
}

void ReturnPath::collect(const PoolTable& pools) {
  for (auto& ring : arrivals_) {
    ReturnedBuffer returned;
    while (ring.pop(returned)) pools[returned.buffer.pool]->give_back(returned.buffer.index);
  }
}

}  // namespace svchain
