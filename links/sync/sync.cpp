#include "links/sync/sync.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rig.h"
#include "framework/link/call.h"
#include "links/sync/channel.h"
#include "links/sync/matching.h"
#include "links/sync/set_ledger.h"

namespace svchain {

namespace {

constexpr const char* kIncomplete = "sync_incomplete";

int64_t ns_from_ms(double ms) {
  return std::llround(ms * 1e6);
}

class Sync final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "sync";
    d.help = "Makes sets of four from frames that were taken at the same moment";
    for (const std::string& camera : geometry::kCameraNames) {
      d.inputs.push_back({.name = camera, .count = 1, .help = "frames of the " + camera + " camera"});
    }
    d.outputs = {{.name = "frames", .count = 4, .forwards = geometry::kCameraNames, .help = "sets of four"}};
    d.parameters = {
        number("delta_ms", 10, {0, 1e4}, "ms", "frames of a set are at most so far from its median time"),
        number("threshold_ms", 100, {1, 1e5}, "ms",
               "a camera that the others have left behind by more is gone"),
        integer("queue", 10, {2, 64}, "frames", "frames of a camera that may wait for the others"),
        choice("missing", "repeat", {"repeat", "skip"},
               "what becomes of a set when a camera has nothing for it"),
    };
    d.trigger = Trigger::kAny;
    return d;
  }

  void configure(Configuration& configuration) override {
    const Parameters& parameters = configuration.parameters();
    name_ = configuration.link_name();
    rule_.delta_ns = ns_from_ms(parameters.number("delta_ms"));
    rule_.threshold_ns = ns_from_ms(parameters.number("threshold_ms"));
    rule_.all_have_come = false;
    repeat_ = parameters.text("missing") == "repeat";
    first_ns_.reset();
    const auto queue = static_cast<size_t>(parameters.integer("queue"));
    ledger_ = SetLedger(kChannels * queue);
    PortFormat set;
    for (size_t c = 0; c < kChannels; ++c) {
      channels_[c] = Channel();
      channels_[c].queue = FrameQueue(queue);
      configuration.holds(static_cast<int>(c), static_cast<int>(queue) + (repeat_ ? 1 : 0));
      const PortFormat& input = configuration.input(static_cast<int>(c));
      set.insert(set.end(), input.begin(), input.end());
    }
    configuration.output(0, set);
  }

  void process(Call& call) override {
    for (size_t c = 0; c < kChannels; ++c) {
      if (Frame frame = call.take(static_cast<int>(c))) keep(channels_[c], std::move(frame));
    }
    send_sets(call);
  }

  bool finish(Call& call) override {
    rule_.all_have_come = true;
    send_sets(call);
    const bool empty =
        std::all_of(channels_.begin(), channels_.end(), [](const Channel& c) { return c.queue.empty(); });
    if (empty) count(call, ledger_.settle_all());
    return empty;
  }

  void stop() override {
    for (Channel& channel : channels_) {
      channel.queue.clear();
      channel.last.release();
    }
  }

  void report(nlohmann::json& report) const override {
    nlohmann::json& cameras = report["links"][name_]["dropped_frames"];
    for (size_t c = 0; c < kChannels; ++c) {
      nlohmann::json& camera = cameras[geometry::kCameraNames[c]];
      for (size_t reason = 0; reason < kDropReasons; ++reason) {
        camera[kDropReasonNames[reason]] = channels_[c].dropped[reason];
      }
      report["links"][name_]["repeated_frames"][geometry::kCameraNames[c]] = channels_[c].repeated;
    }
  }

 private:
  void keep(Channel& channel, Frame&& frame) {
    const int64_t time_ns = frame.timestamp_ns();
    if (!first_ns_) first_ns_ = time_ns;
    ledger_.seen(frame.sequence());
    const auto before = channel.queue.empty() ? channel.last_time_ns : std::optional(channel.newest_ns());
    if (before == time_ns) {
      ++channel.dropped[static_cast<size_t>(DropReason::kDuplicate)];
      return;
    }
    if (channel.queue.full()) drop_head(channel, DropReason::kQueueFull);
    channel.queue.push(std::move(frame));
  }

  void send_sets(Call& call) {
    while (call.room(0) > 0) {
      const Decision decision = decide(channels_, rule_, first_ns_.value_or(0));
      switch (decision.kind) {
        case Decision::Kind::kWait:
          return;
        case Decision::Kind::kGone:
          channels_[decision.channel].gone = true;
          break;
        case Decision::Kind::kDrop:
          // A frame that is only late: its camera is back, and worth waiting for.
          if (decision.reason == DropReason::kTooOld) channels_[decision.channel].gone = false;
          drop_head(channels_[decision.channel], decision.reason);
          break;
        case Decision::Kind::kSet:
          shown_already(decision) ? drop_fresh(decision, DropReason::kTooOld) : make_set(call, decision);
          break;
      }
    }
  }

  /// Of a moment of which there has been a set: cameras whose time stamps are off together would make another.
  bool shown_already(const Decision& decision) const {
    for (size_t c = 0; c < kChannels; ++c) {
      if (decision.fresh[c] && channels_[c].queue.front().sequence() >= ledger_.next()) return false;
    }
    return true;
  }

  void drop_fresh(const Decision& decision, DropReason reason) {
    for (size_t c = 0; c < kChannels; ++c) {
      if (!decision.fresh[c]) continue;
      channels_[c].gone = false;
      drop_head(channels_[c], reason);
    }
  }

  void make_set(Call& call, const Decision& decision) {
    const uint64_t sequence = std::max(ledger_.next(), channels_[decision.channel].queue.front().sequence());
    count(call, ledger_.settle(sequence));
    const bool complete =
        std::all_of(decision.fresh.begin(), decision.fresh.end(), [](bool fresh) { return fresh; });
    if (!complete && !repeat_) return give_up(call, decision);
    Frame set;
    int64_t captured_ns = channels_[decision.channel].queue.front().captured_ns();
    for (size_t c = 0; c < kChannels; ++c) {
      Channel& channel = channels_[c];
      if (decision.fresh[c]) {
        captured_ns = std::min(captured_ns, channel.queue.front().captured_ns());
        set.append(leave(channel));
        channel.gone = false;
      } else if (channel.last) {
        ++channel.repeated;
        set.append(channel.last.share());
      } else {
        set.append_missing();
      }
    }
    set.set_sequence(sequence);
    set.set_captured_ns(captured_ns);
    call.send(0, std::move(set));
  }

  void give_up(Call& call, const Decision& decision) {
    drop_fresh(decision, DropReason::kIncompleteSet);
    count(call, 1);
  }

  void drop_head(Channel& channel, DropReason reason) {
    ++channel.dropped[static_cast<size_t>(reason)];
    const auto time_ns = channel.last_time_ns;
    leave(channel);
    if (reason == DropReason::kWildTimestamp) channel.last_time_ns = time_ns;
  }

  /// Takes the head out of the queue, keeping what may have to be repeated: of dropped frames too, being the
  /// newest picture that the camera has given.
  Frame leave(Channel& channel) {
    Frame frame = channel.queue.pop();
    channel.last_time_ns = frame.timestamp_ns();
    if (repeat_) channel.last = frame.share();
    return frame;
  }

  static void count(Call& call, uint64_t sets) {
    if (sets > 0) call.drop(kIncomplete, sets);
  }

  std::string name_;
  MatchingRule rule_;
  bool repeat_ = true;
  Channels channels_;
  SetLedger ledger_;
  std::optional<int64_t> first_ns_;
};

}  // namespace

std::unique_ptr<Link> make_sync() {
  return std::make_unique<Sync>();
}

}  // namespace svchain
