#include "framework/chain/runner.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace svchain {

Runner::Runner(std::string name, std::string core, std::unique_ptr<Link>& link,
               const LinkDescription& description, OnError on_error, Holder& holder, const Clock& clock,
               Hooks hooks)
    : trigger_on_(description.trigger),
      inputs_(description.inputs.size()),
      outputs_(description.outputs.size()),
      link_(link),
      holder_(holder),
      clock_(clock),
      on_error_(on_error),
      name_(std::move(name)),
      core_(std::move(core)),
      description_(description),
      hooks_(std::move(hooks)) {
  for (size_t i = 0; i < inputs_.size(); ++i) {
    inputs_[i].intake = description_.inputs[i].intake;
    inputs_[i].optional = description_.inputs[i].optional;
  }
}

void Runner::set_recorder(int number, Recorder& recorder) {
  number_ = number;
  recorder_ = &recorder;
}

void Runner::connect_input(int port, Edge& edge, bool feedback, bool exact) {
  In& in = inputs_[static_cast<size_t>(port)];
  in.edge = &edge;
  in.feedback = feedback;
  if (feedback) in.optional = true;  // its initial token is the link's own initial state
  if (feedback && !exact) in.intake = Intake::kState;
  takes_states_ = takes_states_ || in.intake == Intake::kState;
  edge.set_wants_absence(in.intake == Intake::kEach);
}

void Runner::connect_output(int port, Edge* edge, std::vector<Pool*> pools, bool preloaded) {
  Out& out = outputs_[static_cast<size_t>(port)];
  out.edge = edge;
  out.pools = std::move(pools);
  out.preloaded = preloaded;
}

Runner::Waiting Runner::waiting(int64_t now_ns) {
  now_ns_ = now_ns;
  switch (state_) {
    case State::kIdle:
      return {Wait::kEnded, -1};
    case State::kEnded:
      for (const In& in : inputs_) {
        if (in.edge && in.edge->front()) return {};  // there is something to discard
      }
      return {Wait::kEnded, -1};
    case State::kFinishing:
      return waiting_outputs();
    case State::kRunning:
      break;
  }
  if (keeps_newest_ && states_requested()) return {};
  if (is_source()) {
    if (end_requested_.load(std::memory_order_acquire)) return {};
    if (now_ns < wake_at_ns_) return {Wait::kTime, -1};
    return calls_without_room_ ? Waiting{} : waiting_outputs();
  }
  if (const Waiting w = waiting_inputs(); !w.ready()) return w;
  return waiting_outputs();
}

/// States first, whatever else is missing: who sends them may be what the rest waits for.
Runner::Waiting Runner::waiting_inputs() {
  if (takes_states_) absorb_states();
  int feedback_port = -1;
  bool any = false;
  for (size_t i = 0; i < inputs_.size(); ++i) {
    In& in = inputs_[i];
    const int port = static_cast<int>(i);
    if (!in.edge) continue;
    if (in.intake == Intake::kState) {
      if (!in.frame && !in.optional && !in.ended) return {Wait::kFrame, port};
    } else if (in.feedback) {
      if (!feedback_ready(in)) feedback_port = port;
    } else if (trigger_on_ == Trigger::kAny) {
      any = any || in.edge->front();
    } else if (!in.edge->front()) {
      return {Wait::kFrame, port};
    }
  }
  if (trigger_on_ == Trigger::kAny && !any) return {Wait::kFrame, 0};
  if (feedback_port >= 0 && !feedback_excused_) return {Wait::kFeedback, feedback_port};
  return {};
}

Runner::Waiting Runner::waiting_outputs() {
  for (size_t i = 0; i < outputs_.size(); ++i) {
    Out& out = outputs_[i];
    const bool was_full = std::exchange(out.full, out.edge && !out.edge->has_room());
    if (out.full) {
      if (!was_full) out.edge->note_full();
      return {Wait::kRoom, static_cast<int>(i)};
    }
    if (out.preloaded) continue;
    for (Pool* pool : out.pools) {
      if (!has_memory(*pool)) return {Wait::kBuffer, static_cast<int>(i)};
    }
  }
  return {};
}

bool Runner::has_memory(Pool& pool) const {
  if (faults_ && faults_->link.in_force(FaultKind::kNoMemory)) return false;
  return holder_.has_free(pool);
}

/// The token that answers the last call, older ones being of no more use. Before the first call nothing is
/// waited for.
bool Runner::feedback_ready(In& in) {
  while (const ipc::Message* oldest = in.edge->front()) {
    if (oldest->kind == ipc::MessageKind::kEnd) return true;
    if (called_ && oldest->sequence >= trigger_.sequence) return true;
    take_front(in);
  }
  return !called_;
}

void Runner::absorb_states() {
  for (In& in : inputs_) {
    if (!in.edge || in.intake != Intake::kState) continue;
    absorb_newest(in);
    if (in.lost) in.edge->request_newest();
  }
}

void Runner::absorb_newest(In& in) {
  while (in.edge->front()) {
    const ipc::MessageKind kind = take_front(in);
    in.ended = in.ended || kind == ipc::MessageKind::kEnd;
    in.lost = kind == ipc::MessageKind::kAbsence && !in.feedback && !in.ended;
  }
}

int64_t Runner::run(int64_t now_ns) {
  const Gathered what = act(now_ns);
  let_go_of_inputs();
  const int64_t end_ns = publish_outputs();
  record(what, end_ns);
  return end_ns;
}

/// Everything of a call but its end.
Runner::Gathered Runner::act(int64_t now_ns) {
  now_ns_ = now_ns;
  if (state_ == State::kEnded) {
    discard_inputs();
    return Gathered::kNothing;
  }
  if (keeps_newest_ && states_requested()) {
    send_requested_states();
    return Gathered::kNothing;
  }
  if (state_ == State::kFinishing) {
    finish_link();
    return Gathered::kFinish;
  }
  Gathered gathered = Gathered::kCall;
  if (is_source()) {
    wake_at_ns_ = now_ns;
    if (end_requested_.load(std::memory_order_acquire)) gathered = Gathered::kEnd;
  } else {
    gathered = trigger_on_ == Trigger::kAny ? gather_any() : gather_all();
  }
  if (gathered == Gathered::kCall) call_link();
  if (gathered == Gathered::kSkip) leave_absences();
  if (gathered == Gathered::kEnd) {
    state_ = State::kFinishing;
    if (is_source()) end_outputs();
  }
  return gathered;
}

void Runner::let_go_of_inputs() {
  for (In& in : inputs_) {
    if (in.intake == Intake::kEach) in.frame.release();
  }
}

/// What began at now_ns_, for the statistics and the trace.
void Runner::record(Gathered what, int64_t end_ns) {
  if (what == Gathered::kCall) {
    counters_.process.record(end_ns - now_ns_);
    if (!is_source()) counters_.latency.record(end_ns - trigger_.captured_ns);
    if (faults_ && faults_->recovery && !threw_) faults_->recovery->delivered(end_ns);
  }
  if (!recorder_) return;
  if (what == Gathered::kCall)
    recorder_->called(TraceEvent::Kind::kCall, number_, frame_number(), now_ns_, end_ns);
  if (what == Gathered::kFinish) recorder_->called(TraceEvent::Kind::kFinish, number_, 0, now_ns_, end_ns);
  recorder_->end_run(end_ns);
}

/// The end of a call, for the statistics as for what it has sent.
int64_t Runner::publish_outputs() {
  const int64_t end_ns = clock_.now_ns();
  for (Out& out : outputs_) {
    if (out.edge) out.edge->publish(end_ns);
  }
  if (faults_) count_lost_set();
  return end_ns;
}

/// An edge that drops may have taken its frame back since it was looked at; from here on it does not.
bool Runner::fronts_are_there() {
  for (In& in : inputs_) {
    if (!in.edge || in.intake == Intake::kState || in.feedback) continue;
    if (!in.edge->front()) return false;
  }
  return true;
}

ipc::MessageKind Runner::take_front(In& in) {
  const ipc::Message& front = *in.edge->front();
  const ipc::MessageKind kind = front.kind;
  if (kind == ipc::MessageKind::kFrame) in.frame.receive(front, holder_);
  in.edge->pop(now_ns_);
  return kind;
}

Runner::Gathered Runner::gather_all() {
  if (!fronts_are_there()) return Gathered::kNothing;
  Gathered gathered = Gathered::kCall;
  lost_at_ = 0;
  std::optional<Moment> moment;
  bool state_missing = false;
  for (In& in : inputs_) {
    if (!in.edge) continue;
    if (in.intake == Intake::kState) {
      state_missing = state_missing || (!in.frame && !in.optional);
    } else if (in.feedback) {
      gather_feedback(in);
    } else {
      if (!moment) moment = moment_of(*in.edge->front());
      note_loss(in.edge->front()->lost_at);
      const ipc::MessageKind kind = take_front(in);
      if (kind == ipc::MessageKind::kEnd) gathered = Gathered::kEnd;
      if (kind == ipc::MessageKind::kAbsence && gathered == Gathered::kCall) gathered = Gathered::kSkip;
    }
  }
  feedback_excused_ = false;
  if (state_missing && gathered == Gathered::kCall) {  // it ended without ever giving one
    drop("state_missing", 1);
    gathered = Gathered::kSkip;
  }
  if (gathered != Gathered::kEnd) {
    if (moment) trigger_ = *moment;
    called_ = true;
  }
  return gathered;
}

/// A set that is missing for two reasons has been counted for both.
void Runner::note_loss(uint16_t lost_at) {
  if (lost_at == 0 || lost_at == lost_at_) return;
  if (lost_at_ != 0) counters_.counted_twice.add(is_lost_on_edge(lost_at) ? kLostOnEdge : kLostInCall);
  lost_at_ = lost_at;
}

void Runner::gather_feedback(In& in) {
  if (!called_) return;
  if (!in.edge->front()) return counters_.late_feedback.add();
  take_front(in);
}

Runner::Gathered Runner::gather_any() {
  bool frames = false;
  bool all_ended = true;
  for (In& in : inputs_) {
    if (!in.edge || in.ended) continue;
    if (const ipc::Message* front = in.edge->front()) {
      const Moment moment = moment_of(*front);
      const ipc::MessageKind kind = take_front(in);
      if (kind == ipc::MessageKind::kEnd) in.ended = true;
      if (kind == ipc::MessageKind::kFrame && !std::exchange(frames, true)) trigger_ = moment;
    }
    all_ended = all_ended && in.ended;
  }
  // Nothing but absences and ends: a call without frames has nothing to say.
  if (frames) {
    if (all_ended) state_ = State::kFinishing;
    return Gathered::kCall;
  }
  return all_ended ? Gathered::kEnd : Gathered::kSkip;
}

void Runner::call_link() {
  for (Out& out : outputs_) out.sent = false;
  threw_ = true;
  try {
    if (faults_ && !throws_as_it_sends()) throw_if_struck(trigger_.sequence);
    link_->process(*this);
    if (faults_ && faults_->takes_time) take_longer(now_ns_);
    threw_ = false;
  } catch (const std::exception& error) {
    fail(error.what());
  } catch (...) {
    fail("threw something that is no std::exception");
  }
  if (!threw_) counters_.processed.add();
  leave_absences();
}

void Runner::fail(const char* what) {
  drop(kLostInCall, 1);
  lost_at_ = place_;
  if (on_error_ == OnError::kDrop) return;
  failed_ = true;
  state_ = State::kFinishing;
  hooks_.failed({core_, name_, frame_number(), what});
}

/// Of this call; a source's is what it has captured last.
uint64_t Runner::frame_number() const {
  const uint64_t captured = counters_.captured.value();
  return is_source() ? captured - (captured > 0 ? 1 : 0) : trigger_.sequence;
}

/// Whatever this call has not sent is missing for good: those who wait for it are told.
void Runner::leave_absences() {
  if (is_source() || trigger_on_ == Trigger::kAny) return;
  for (Out& out : outputs_) {
    if (out.edge && !out.sent && out.edge->wants_absence()) {
      ipc::Message absence;
      absence.kind = ipc::MessageKind::kAbsence;
      absence.sequence = trigger_.sequence;
      absence.captured_ns = trigger_.captured_ns;
      absence.lost_at = lost_at_;
      out.edge->send(absence);
    }
    out.sent = false;
  }
}

void Runner::finish_link() {
  bool done = true;
  try {
    if (!failed_) done = link_->finish(*this);
  } catch (const std::exception& error) {
    fail(error.what());
  }
  if (done) end_outputs();
}

void Runner::end_outputs() {
  for (Out& out : outputs_) {
    if (out.edge) out.edge->send_end();
  }
  state_ = State::kEnded;
  hooks_.ended();
}

void Runner::discard_inputs() {
  for (In& in : inputs_) {
    if (in.edge) absorb_newest(in);
  }
  release_frames();
}

void Runner::release_frames() {
  for (In& in : inputs_) in.frame.release();
  for (Out& out : outputs_) out.newest.release();
  if (!faults_) return;
  for (auto& output : faults_->outputs) {
    if (output) output->release();
  }
}

}  // namespace svchain
