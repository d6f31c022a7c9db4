#pragma once
// Which frames of four cameras belong together. Looks at nothing but time stamps and the order of arrival,
// never at a clock: the same frames always make the same sets. Pure function.
//
// The heads of the queues are compared with their median (after the Vision SDK's Sync link, whose mean one
// wild time stamp could pull anywhere). Heads within +- delta of it make a set; an older one is dropped, as
// nothing will match it any more; a newer one stays for a later set, and its camera is missing from this one.

#include "links/sync/channel.h"

namespace svchain {

struct MatchingRule {
  int64_t delta_ns = 0;
  int64_t threshold_ns = 0;
  bool all_have_come = false;  // the inputs have ended: nobody is waited for
};

struct Decision {
  enum class Kind {
    kWait,  // for a camera that has no frame there
    kGone,  // `channel` is given up
    kDrop,  // the head of `channel`, for `reason`
    kSet,   // of the heads of those that are `fresh`
  };
  Kind kind = Kind::kWait;
  size_t channel = 0;  // of a set: whose frame is nearest to the median
  DropReason reason = DropReason::kTooOld;
  std::array<bool, kChannels> fresh{};
};

/// `first_ns`: the first time stamp of the run, what cameras that never came are measured by.
Decision decide(const Channels& channels, const MatchingRule& rule, int64_t first_ns);

}  // namespace svchain
