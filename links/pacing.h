#pragma once
// When a source hands out which set. Lossless runs take every set, as soon as there is room; in real time set
// n is due n / fps after the start, and what is not handed out then is counted and gone. A clock that is set
// back takes the start along; sets that it skips when it is set forward are late ones. Belongs to its link's
// core; allocates nothing.

#include <cstdint>
#include <optional>
#include <span>

#include "framework/link/call.h"
#include "framework/link/link.h"

namespace svchain {

class Pacing {
 public:
  Pacing() = default;
  /// `sets`: how many there are; nothing: without end. A link whose pacing is in real time has to ask for
  /// Configuration::calls_without_room().
  Pacing(const Pace& pace, std::optional<uint64_t> sets, bool real_time);

  /// The set to hand out in this call, for the link to count as captured; nothing where none is due, or where
  /// it had to be dropped because one of the outputs has no room. Also says when to be called again, and ends
  /// the stream.
  std::optional<uint64_t> due(Call& call, std::span<const int> outputs);

  /// When set n is due after the start; its nominal time stamp.
  int64_t due_ns(uint64_t set) const;

 private:
  uint64_t newest_due(int64_t since_start_ns) const;
  void advance(Call& call, uint64_t set);

  double fps_ = 30;
  std::optional<uint64_t> sets_;
  bool real_time_ = false;
  bool timed_ = false;
  uint64_t next_ = 0;
  std::optional<int64_t> start_ns_;
  int64_t last_ns_ = 0;  // of the last call
};

}  // namespace svchain
