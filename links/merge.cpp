#include "links/merge.h"

#include <algorithm>
#include <array>

#include "framework/link/call.h"
#include "ipc/message.h"
#include "links/frame_queue.h"

namespace svchain {

namespace {

constexpr size_t kInputs = 4;
constexpr size_t kWaiting = 8;  // frames of an input that wait for their counterparts

class Merge final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "merge";
    d.help = "Joins frames of the same sequence number to one set";
    for (size_t i = 0; i < kInputs; ++i) {
      d.inputs.push_back({.name = "in" + std::to_string(i), .optional = true, .help = "frames or sets"});
    }
    d.outputs = {{.name = "frames", .forwards = {"in0", "in1", "in2", "in3"}, .help = "sets"}};
    return d;
  }

  void configure(Configuration& configuration) override {
    PortFormat set;
    connected_ = {};
    for (size_t i = 0; i < kInputs; ++i) {
      const PortFormat& input = configuration.input(static_cast<int>(i));
      connected_[i] = !input.empty();
      if (!connected_[i]) continue;
      queues_[i] = FrameQueue(kWaiting);
      configuration.holds(static_cast<int>(i), kWaiting);
      set.insert(set.end(), input.begin(), input.end());
    }
    if (set.empty()) configuration.fault("none of in0, in1, in2 and in3 is connected, expected at least one");
    if (set.size() > ipc::kMaxBuffers) {
      configuration.fault("the inputs carry " + std::to_string(set.size()) +
                          " buffers together, a set has at most " + std::to_string(ipc::kMaxBuffers));
    }
    configuration.output(0, set);
  }

  /// Every connected input brings a frame, so that at most one set becomes complete.
  void process(Call& call) override {
    for (size_t i = 0; i < kInputs; ++i) {
      if (!connected_[i]) continue;
      while (queues_[i].full()) drop_oldest(call);
      queues_[i].push(call.take(static_cast<int>(i)));
    }
    while (every([](const FrameQueue& queue) { return !queue.empty(); })) {
      const uint64_t oldest = oldest_sequence();
      if (every([&](const FrameQueue& queue) { return queue.front().sequence() == oldest; })) {
        send_set(call);
      } else {
        drop_oldest(call);
      }
    }
  }

  bool finish(Call& call) override {
    while (!every([](const FrameQueue& queue) { return queue.empty(); })) drop_oldest(call);
    return true;
  }

  void stop() override {
    for (FrameQueue& queue : queues_) queue.clear();
  }

 private:
  template <class Condition>
  bool every(Condition condition) const {
    for (size_t i = 0; i < kInputs; ++i) {
      if (connected_[i] && !condition(queues_[i])) return false;
    }
    return true;
  }

  uint64_t oldest_sequence() const {
    uint64_t oldest = UINT64_MAX;
    for (const FrameQueue& queue : queues_) {
      if (!queue.empty()) oldest = std::min(oldest, queue.front().sequence());
    }
    return oldest;
  }

  void send_set(Call& call) {
    Frame set;
    for (size_t i = 0; i < kInputs; ++i) {
      if (connected_[i]) set.append(queues_[i].pop());
    }
    call.send(0, std::move(set));
  }

  void drop_oldest(Call& call) {
    const uint64_t oldest = oldest_sequence();
    for (FrameQueue& queue : queues_) {
      if (!queue.empty() && queue.front().sequence() == oldest) queue.pop();
    }
    call.drop("unmatched");
  }

  std::array<bool, kInputs> connected_{};
  std::array<FrameQueue, kInputs> queues_;
};

}  // namespace

std::unique_ptr<Link> make_merge() {
  return std::make_unique<Merge>();
}

}  // namespace svchain
