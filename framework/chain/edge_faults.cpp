// What faults do to an edge, and how a state that got lost is had again. The edge itself is in edge.cpp.

#include "framework/buffer/frame.h"
#include "framework/chain/edge.h"

namespace svchain {

void Edge::set_faults(FaultSite& site, CoreFaults& core, uint16_t place) {
  trouble_ = std::make_unique<Trouble>(Trouble{site, core, place});
}

/// A source that gives nothing leaves no word of it.
void Edge::leave_if_nothing_is_wrong(ipc::Message message) {
  const uint64_t occasion = message.sequence + (trouble_->times_again << 40);
  FaultSite& site = trouble_->site;
  if (site.strike(FaultKind::kDropout, occasion)) return lose(message, "dropout");
  if (site.strike(FaultKind::kLost, occasion)) {
    if (message.kind == ipc::MessageKind::kAbsence) return apply_policy(message);  // which says as little
    lose(message, kLostOnEdge);
    message.kind = ipc::MessageKind::kAbsence;
    message.count = 0;
    message.lost_at = trouble_->place;
  }
  const int64_t now_ns = clock_.now_ns();
  const PlannedFault* late = site.strike(FaultKind::kLate, occasion);
  if (!late && trouble_->late.empty()) return apply_policy(message);
  hold_up(message, now_ns + (late ? late->amount_ns : 0));
}

void Edge::lose(const ipc::Message& message, const char* reason) {
  if (message.kind != ipc::MessageKind::kFrame) return;
  trouble_->lost = true;
  dropped_.add(reason);
  if (producer_recorder_) producer_recorder_->edge_dropped(number_, reason);
  Frame(message, *producer_.holder).release();
}

/// Nothing overtakes what was sent before it.
void Edge::hold_up(const ipc::Message& message, int64_t due_ns) {
  std::deque<Late>& late = trouble_->late;
  if (!late.empty()) due_ns = std::max(due_ns, late.back().due_ns);
  late.push_back({message, due_ns});
  trouble_->core.look_again_at(late.front().due_ns);
}

void Edge::send_late(int64_t now_ns) {
  if (late() == 0) return;
  std::deque<Late>& late = trouble_->late;
  for (; !late.empty() && late.front().due_ns <= now_ns; late.pop_front()) {
    ipc::Message& message = late.front().message;
    message.sent_ns = now_ns;
    message.kind == ipc::MessageKind::kEnd ? void(push(message)) : apply_policy(message);
  }
  publish(now_ns);
  if (way_ == Way::kModelled) tell_if_arrived();
  if (!late.empty()) trouble_->core.look_again_at(late.front().due_ns);
}

void Edge::drop_late() {
  if (!trouble_) return;
  for (const Late& late : trouble_->late) Frame(late.message, *producer_.holder).release();
  trouble_->late.clear();
}

bool Edge::request_newest() {
  if (oldest() || (way_ == Way::kModelled && local_.front())) return false;  // something is on its way
  waits_->state.set();
  if (ipc()) {
    producer_.doorbell->ring(bell_of(producer_.runner));
  } else {
    producer_.attention->mark(producer_.runner);
  }
  return true;
}

}  // namespace svchain
