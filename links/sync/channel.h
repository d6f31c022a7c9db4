#pragma once
// One camera's side of a sync: the frames that wait, what came last, what was dropped and why. Belongs to its
// link's core.

#include <array>
#include <cstdint>
#include <optional>

#include "links/frame_queue.h"

namespace svchain {

enum class DropReason {
  kTooOld,         // behind the median of the cameras by more than delta
  kWildTimestamp,  // far from all the others, or ahead of the same camera's next frame
  kDuplicate,      // the same time stamp again
  kQueueFull,      // waited in vain
  kIncompleteSet,  // its set was given up for another camera's sake
};
constexpr size_t kDropReasons = 5;
inline constexpr std::array<const char*, kDropReasons> kDropReasonNames = {
    "too_old", "wild_timestamp", "duplicate", "queue_full", "incomplete_set"};

struct Channel {
  FrameQueue queue;
  Frame last;                           // the newest that has left the queue, to be repeated
  std::optional<int64_t> last_time_ns;  // of what has left the queue, wild time stamps apart
  bool gone = false;                    // nobody waits for it until it is back
  std::array<uint64_t, kDropReasons> dropped{};
  uint64_t repeated = 0;

  int64_t head_ns() const { return queue.front().timestamp_ns(); }
  int64_t newest_ns() const { return queue.back().timestamp_ns(); }
};

constexpr size_t kChannels = 4;
using Channels = std::array<Channel, kChannels>;

}  // namespace svchain
