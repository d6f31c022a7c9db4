#pragma once
// Which sets have been seen in part and not yet been made, so that every set is accounted for once: made, or
// dropped. Numbers missing altogether (dropped at the capture and counted there) are no business of it.
// Belongs to its link's core; allocates at construction only.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace svchain {

class SetLedger {
 public:
  /// `capacity`: sets that can be under way at a time.
  explicit SetLedger(size_t capacity = 0) { open_.reserve(capacity + 1); }

  /// A frame of this set has come.
  void seen(uint64_t sequence);
  /// This set is made, or given up. Returns how many older ones never will be.
  uint64_t settle(uint64_t sequence);
  /// Nothing follows. Returns how many never were made.
  uint64_t settle_all();
  /// The least number that a set to come may have.
  uint64_t next() const { return next_; }

 private:
  uint64_t forget_before(uint64_t sequence);

  std::vector<uint64_t> open_;  // rising
  uint64_t next_ = 0;
  uint64_t overflown_ = 0;
};

}  // namespace svchain
