#include "links/sync/set_ledger.h"

#include <algorithm>
#include <utility>

namespace svchain {

void SetLedger::seen(uint64_t sequence) {
  if (sequence < next_) return;
  const auto at = std::lower_bound(open_.begin(), open_.end(), sequence);
  if (at != open_.end() && *at == sequence) return;
  open_.insert(at, sequence);
  if (open_.size() < open_.capacity()) return;
  overflown_ += forget_before(open_.front() + 1);
}

uint64_t SetLedger::settle(uint64_t sequence) {
  const uint64_t never = forget_before(sequence) + std::exchange(overflown_, 0);
  forget_before(sequence + 1);
  next_ = std::max(next_, sequence + 1);
  return never;
}

uint64_t SetLedger::settle_all() {
  return open_.empty() ? std::exchange(overflown_, 0) : settle(open_.back()) + 1;
}

uint64_t SetLedger::forget_before(uint64_t sequence) {
  const auto end = std::lower_bound(open_.begin(), open_.end(), sequence);
  const auto count = static_cast<uint64_t>(end - open_.begin());
  open_.erase(open_.begin(), end);
  return count;
}

}  // namespace svchain
