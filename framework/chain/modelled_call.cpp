// A runner's calls in modelled time, begin and end apart. The call itself is the one of runner.cpp.

#include <utility>

#include "framework/chain/runner.h"

namespace svchain {

Runner::Work Runner::begin_call(int64_t now_ns) {
  Work work;
  for (const In& in : inputs_) {
    const bool taken = in.edge && in.intake == Intake::kEach && !in.feedback;
    if (const ipc::Message* front = taken ? in.edge->front() : nullptr) work.input_px += px_of(*front);
  }
  under_way_ = act(now_ns);
  work.called = in_call();
  for (const Out& out : outputs_) {
    if (!out.edge) continue;
    for (const ipc::Message& message : out.edge->held_back()) {
      work.sent = work.sent || message.kind == ipc::MessageKind::kFrame;
      work.output_px += px_of(message);
    }
  }
  return work;
}

void Runner::end_call(int64_t end_ns) {
  let_go_of_inputs();
  for (Out& out : outputs_) {
    if (out.edge) out.edge->hand_over(end_ns);
  }
  if (faults_) count_lost_set();
  record(std::exchange(under_way_, Gathered::kNothing), end_ns);
}

uint64_t Runner::px_of(const ipc::Message& message) const {
  uint64_t px = 0;
  for (size_t i = 0; i < message.count; ++i) {
    if (message.buffers[i] == ipc::kNoBuffer) continue;
    const Format& format = holder_.pool(message.buffers[i]).format();
    px += static_cast<uint64_t>(format.width_px) * static_cast<uint64_t>(format.height_px);
  }
  return px;
}

}  // namespace svchain
