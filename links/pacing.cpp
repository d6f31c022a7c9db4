#include "links/pacing.h"

#include <algorithm>
#include <cmath>

namespace svchain {

Pacing::Pacing(const Pace& pace, std::optional<uint64_t> sets, bool real_time)
    : fps_(pace.fps), sets_(sets), real_time_(real_time), timed_(real_time || pace.virtual_clock) {}

int64_t Pacing::due_ns(uint64_t set) const {
  return std::llround(static_cast<double>(set) * 1e9 / fps_);
}

std::optional<uint64_t> Pacing::due(Call& call, std::span<const int> outputs) {
  if (sets_ && next_ >= *sets_) {
    call.end();
    return std::nullopt;
  }
  if (!start_ns_) start_ns_ = last_ns_ = call.now_ns();
  if (call.now_ns() < last_ns_) *start_ns_ -= last_ns_ - call.now_ns();
  last_ns_ = call.now_ns();
  if (timed_ && call.now_ns() < *start_ns_ + due_ns(next_)) {
    call.wake_at(*start_ns_ + due_ns(next_));
    return std::nullopt;
  }
  uint64_t set = next_;
  if (real_time_) {
    set = newest_due(call.now_ns() - *start_ns_);
    if (const uint64_t late = set - next_) {
      call.captured(late);
      call.drop("late", late);
    }
  }
  advance(call, set);
  const bool room =
      std::all_of(outputs.begin(), outputs.end(), [&](int port) { return call.room(port) > 0; });
  if (real_time_ && !room) {
    call.captured();
    call.drop("downstream_full");
    return std::nullopt;
  }
  return set;
}

/// At least next_, which is due.
uint64_t Pacing::newest_due(int64_t since_start_ns) const {
  auto set = static_cast<uint64_t>(static_cast<double>(since_start_ns) * fps_ / 1e9);
  while (due_ns(set + 1) <= since_start_ns) ++set;
  while (set > next_ && due_ns(set) > since_start_ns) --set;
  if (sets_) set = std::min(set, *sets_ - 1);
  return std::max(set, next_);
}

void Pacing::advance(Call& call, uint64_t set) {
  next_ = set + 1;
  if (sets_ && next_ >= *sets_) {
    call.end();
  } else if (timed_) {
    call.wake_at(*start_ns_ + due_ns(next_));
  }
}

}  // namespace svchain
