#include "links/sync/matching.h"

#include <algorithm>
#include <cstdlib>

namespace svchain {

namespace {

/// Time stamps further from the others than this many thresholds cannot be right.
constexpr int64_t kWildThresholds = 10;

/// The times of some channels, rising.
struct Times {
  std::array<int64_t, kChannels> ns{};
  size_t count = 0;

  void add(int64_t t) {
    size_t at = count++;
    for (; at > 0 && ns[at - 1] > t; --at) ns[at] = ns[at - 1];
    ns[at] = t;
  }
  int64_t lower_median() const { return ns[(count - 1) / 2]; }
  int64_t upper_median() const { return ns[count / 2]; }
  int64_t median() const { return lower_median() + (upper_median() - lower_median()) / 2; }
};

/// Nothing has come from it while the others have gone on by two frames each and by more than the threshold,
/// or have filled a queue with waiting.
bool is_gone(const Channels& channels, size_t waited_for, const MatchingRule& rule, int64_t first_ns) {
  if (std::any_of(channels.begin(), channels.end(), [](const Channel& c) { return c.queue.full(); }))
    return true;
  Times newest;
  for (const Channel& channel : channels) {
    if (channel.queue.size() == 1) return false;
    if (!channel.queue.empty()) newest.add(channel.newest_ns());
  }
  const int64_t last = channels[waited_for].last_time_ns.value_or(first_ns);
  return newest.count > 0 && newest.lower_median() - last > rule.threshold_ns;
}

/// The median of the heads; where two pairs stand so far apart that it lies between them, the older pair.
int64_t master_time(const Channels& channels, int64_t delta_ns) {
  Times heads;
  for (const Channel& channel : channels) {
    if (!channel.queue.empty()) heads.add(channel.head_ns());
  }
  const int64_t median = heads.median();
  return heads.upper_median() - median <= delta_ns ? median : heads.lower_median();
}

/// Why a head is of no use, if it is not.
std::optional<DropReason> fault_of(const Channel& channel, int64_t master_ns, const MatchingRule& rule) {
  const int64_t offset = channel.head_ns() - master_ns;
  if (std::abs(offset) <= rule.delta_ns) return std::nullopt;
  if (std::abs(offset) > kWildThresholds * rule.threshold_ns) return DropReason::kWildTimestamp;
  if (offset < 0) return DropReason::kTooOld;
  const bool time_runs_back = channel.queue.size() > 1 && channel.queue[1].timestamp_ns() < channel.head_ns();
  return time_runs_back ? std::optional(DropReason::kWildTimestamp) : std::nullopt;
}

}  // namespace

Decision decide(const Channels& channels, const MatchingRule& rule, int64_t first_ns) {
  Decision decision;
  bool any = false;
  for (const Channel& channel : channels) any = any || !channel.queue.empty();
  if (!any) return decision;

  for (size_t c = 0; c < kChannels; ++c) {
    if (!channels[c].queue.empty() || channels[c].gone) continue;
    if (!rule.all_have_come && !is_gone(channels, c, rule, first_ns)) return decision;
    decision.kind = Decision::Kind::kGone;
    decision.channel = c;
    return decision;
  }

  const int64_t master_ns = master_time(channels, rule.delta_ns);
  int64_t nearest_ns = 0;
  decision.kind = Decision::Kind::kSet;
  for (size_t c = 0; c < kChannels; ++c) {
    if (channels[c].queue.empty()) continue;
    if (const auto reason = fault_of(channels[c], master_ns, rule)) {
      decision.kind = Decision::Kind::kDrop;
      decision.channel = c;
      decision.reason = *reason;
      return decision;
    }
    const int64_t distance_ns = std::abs(channels[c].head_ns() - master_ns);
    if (distance_ns > rule.delta_ns) continue;
    const bool first = std::none_of(decision.fresh.begin(), decision.fresh.end(), [](bool f) { return f; });
    if (first || distance_ns < nearest_ns) {
      nearest_ns = distance_ns;
      decision.channel = c;
    }
    decision.fresh[c] = true;
  }
  return decision;
}

}  // namespace svchain
