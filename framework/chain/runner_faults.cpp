// What faults do to a runner's calls, and what it does about states that got lost. The calls themselves are
// those of runner.cpp.

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "framework/chain/runner.h"

namespace svchain {

/// A link that takes what comes, or makes it, knows its losses only once it has something to send. Others
/// throw before they have begun.
bool Runner::throws_as_it_sends() const {
  return !outputs_.empty() && (is_source() || trigger_on_ == Trigger::kAny);
}

void Runner::throw_if_struck(uint64_t occasion) {
  if (faults_->link.strike(FaultKind::kThrow, occasion))
    throw std::runtime_error("a fault of the fault file");
}

int64_t Runner::slowed_ns(int64_t duration_ns) {
  const PlannedFault* slow = faults_ ? faults_->link.strike(FaultKind::kSlow, frame_number()) : nullptr;
  if (!slow) return duration_ns;
  return static_cast<int64_t>(static_cast<double>(duration_ns) * slow->factor) + slow->amount_ns;
}

void Runner::take_longer(int64_t began_ns) {
  const int64_t so_far_ns = clock_.now_ns() - began_ns;
  const int64_t left_ns = slowed_ns(so_far_ns) - so_far_ns;
  if (left_ns > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(left_ns));
}

/// A set of a source of which nothing has got through is heard of by nobody else.
void Runner::count_lost_set() {
  size_t connected = 0, lost = 0;
  for (Out& out : outputs_) {
    if (!out.edge) continue;
    ++connected;
    if (out.edge->take_lost()) ++lost;
  }
  if (faults_->gives_parts && connected > 0 && lost == connected) drop("lost", 1);
}

void Runner::restart() {
  for (In& in : inputs_) {
    if (in.intake != Intake::kState) continue;  // others are taken anew for every call
    in.lost = in.lost || (in.frame && !in.feedback && !in.ended);
    in.frame.release();
  }
  called_ = false;
}

bool Runner::request_lost_state() {
  bool any = false;
  for (In& in : inputs_) {
    if (in.lost && in.edge->request_newest()) any = true;
  }
  return any;
}

/// Whether it is time to send some again. The first time at once, and then not before a while has passed:
/// what has got lost twice may be lost at once a third time.
bool Runner::states_requested() {
  constexpr int64_t kPause_ns = 20'000'000;
  for (Out& out : outputs_) {
    if (!out.newest || !out.edge->takes_request()) continue;
    out.requested = true;
    send_again_ns_ = std::min(send_again_ns_, std::max(now_ns_, sent_again_ns_ + kPause_ns));
  }
  return now_ns_ >= send_again_ns_;
}

void Runner::send_requested_states() {
  send_again_ns_ = kNever;
  sent_again_ns_ = now_ns_;
  for (Out& out : outputs_) {
    if (!std::exchange(out.requested, false)) continue;
    if (!out.edge->has_room()) continue;  // something is on its way
    Frame again = out.newest.share();
    out.edge->send_again(again.message());
    again.hand_over();
  }
}

}  // namespace svchain
