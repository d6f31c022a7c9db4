// What a runner is to the link that it calls (call.h).

#include <utility>

#include "framework/chain/runner.h"

namespace svchain {

Draft Runner::create(int port) {
  Out& out = outputs_[static_cast<size_t>(port)];
  ipc::Message message;
  message.sequence = trigger_.sequence;
  message.captured_ns = is_source() ? now_ns() : trigger_.captured_ns;
  for (Pool* pool : out.pools) {
    const auto index = has_memory(*pool) ? pool->take() : std::nullopt;
    if (!index) {
      Frame(message, holder_).release();
      return {};
    }
    message.buffers[message.count] = {pool->id(), *index};
    message.timestamp_ns[message.count] = trigger_.timestamp_ns;
    ++message.count;
  }
  return Draft(Frame(message, holder_));
}

void Runner::send(int port, Frame&& frame) {
  Out& out = outputs_[static_cast<size_t>(port)];
  if (faults_) {
    if (throws_as_it_sends()) throw_if_struck(frame.sequence());
    if (is_source()) frame.set_captured_ns(frame.captured_ns() - clock_offset_ns());
    auto& fault = faults_->outputs[static_cast<size_t>(port)];
    if (fault) frame = fault->instead_of(std::move(frame));
  }
  if (!out.edge) return frame.release();  // nobody listens: the buffers go home
  if (!out.edge->has_room()) {
    drop("no_room", 1);
    return frame.release();
  }
  out.sent = true;
  if (out.keeps_newest) out.newest = frame.share();
  out.edge->send(frame.message());
  frame.hand_over();
}

void Runner::run_parts(int count, Workers::Part part, const void* context) {
  if (workers_) return workers_->run(count, part, context);
  for (int i = 0; i < count; ++i) part(context, i);
}

int Runner::room(int port) const {
  const Out& out = outputs_[static_cast<size_t>(port)];
  return out.edge ? out.edge->room() : ipc::kMaxBuffers;
}

}  // namespace svchain
