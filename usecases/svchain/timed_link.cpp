#include "usecases/svchain/timed_link.h"

#include <chrono>
#include <utility>

#include "framework/chain/modelled_time.h"
#include "framework/link/call.h"

namespace svchain::program {

namespace {

uint64_t px_of(const Frame& frame) {
  uint64_t px = 0;
  for (int i = 0; i < frame.count(); ++i) {
    if (!frame.has(i)) continue;
    const Format& format = frame.format(i);
    px += static_cast<uint64_t>(format.width_px) * static_cast<uint64_t>(format.height_px);
  }
  return px;
}

/// The call as the link sees it; what is sent is counted on its way.
class CountedCall final : public Call {
 public:
  CountedCall(Call& call, const std::vector<bool>& connected) : call_(call), connected_(connected) {}

  bool sent() const { return sent_; }
  uint64_t output_px() const { return output_px_; }

  const Frame& input(int port) const override { return call_.input(port); }
  Frame take(int port) override { return call_.take(port); }
  Draft create(int port) override { return call_.create(port); }
  void send(int port, Draft&& draft) override { send(port, std::move(draft).publish()); }
  void send(int port, Frame&& frame) override {
    if (connected_[static_cast<size_t>(port)]) {
      sent_ = true;
      output_px_ += px_of(frame);
    }
    call_.send(port, std::move(frame));
  }
  int room(int port) const override { return call_.room(port); }
  int64_t now_ns() const override { return call_.now_ns(); }
  void drop(const char* reason, uint64_t count) override { call_.drop(reason, count); }
  int cpus() const override { return call_.cpus(); }
  void captured(uint64_t sets) override { call_.captured(sets); }
  void wake_at(int64_t time_ns) override { call_.wake_at(time_ns); }
  void end() override { call_.end(); }

 private:
  void run_parts(int count, void (*part)(const void* context, int part), const void* context) override {
    call_.parallel(count, [part, context](int i) { part(context, i); });
  }

  Call& call_;
  const std::vector<bool>& connected_;
  bool sent_ = false;
  uint64_t output_px_ = 0;
};

}  // namespace

TimedLink::TimedLink(std::unique_ptr<Link> wrapped, const Plan& plan, const PlannedLink& planned,
                     CallTimes& times)
    : WrappedLink(std::move(wrapped)),
      view_px_(static_cast<uint64_t>(view_px(plan.use_case))),
      times_(times) {
  for (size_t i = 0; i < planned.input_edges.size(); ++i) {
    const int edge = planned.input_edges[i];
    const bool each = planned.description.inputs[i].intake == Intake::kEach;
    if (edge >= 0 && each && !plan.edges[static_cast<size_t>(edge)].entry.feedback)
      counted_inputs_.push_back(static_cast<int>(i));
  }
  for (const int edge : planned.output_edges) connected_.push_back(edge >= 0);
}

void TimedLink::process(Call& call) {
  using Clock = std::chrono::steady_clock;
  CallWork work;
  for (const int port : counted_inputs_) work.input_px += px_of(call.input(port));
  CountedCall counted(call, connected_);
  const auto begin = Clock::now();
  link().process(counted);
  const auto end = Clock::now();
  work.sent = counted.sent();
  work.output_px = work.sent && counted.output_px() == 0 ? view_px_ : counted.output_px();
  times_[work].push_back(std::chrono::duration_cast<std::chrono::nanoseconds>(end - begin).count());
}

}  // namespace svchain::program
