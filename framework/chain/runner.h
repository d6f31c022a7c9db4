#pragma once
// Runs one link on its core: finds out whether it can be called, hands it its frames, sends on what it makes,
// and keeps the loops and joins behind it going when a frame is lost (every call leaves, on every output, a
// frame or its absence).
//
// Thread rule: everything on the link's core, but for the counters. No function blocks, locks or allocates.

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/chain/edge.h"
#include "framework/chain/workers.h"
#include "framework/fault/link_faults.h"
#include "framework/link/call.h"
#include "framework/link/link.h"
#include "framework/trace/recorder.h"
#include "framework/usecase/use_case.h"

namespace svchain {

/// A call that threw.
struct Failure {
  std::string core;
  std::string link;
  uint64_t sequence = 0;
  std::string what;
  std::string text() const { return core + "/" + link + ": frame " + std::to_string(sequence) + ": " + what; }
};

struct RunnerCounters {
  Counter processed, captured;
  Counter late_feedback;  // calls that went on without the token of a feedback edge
  DropCounts dropped;
  DropCounts counted_twice;  // sets lost on two ways to this link
  Histogram process, latency;
};

class alignas(ipc::kCacheLine) Runner final : public Call {
 public:
  enum class Wait { kNothing, kFrame, kRoom, kBuffer, kFeedback, kTime, kEnded };
  struct Waiting {
    Wait what = Wait::kNothing;
    int port = -1;
    bool ready() const { return what == Wait::kNothing; }
  };
  struct Hooks {
    std::function<void(Failure)> failed;  // a call threw and the link's policy is to stop
    std::function<void()> ended;          // nothing more will come from this link
  };

  Runner(std::string name, std::string core, std::unique_ptr<Link>& link, const LinkDescription& description,
         OnError on_error, Holder& holder, const Clock& clock, Hooks hooks);

  /// `exact`: the feedback token that answers the last call is waited for (lossless runs); otherwise the
  /// newest serves.
  void connect_input(int port, Edge& edge, bool feedback, bool exact);
  /// `pools`: one for every buffer of a frame made here; empty where the output forwards. `edge` may be null.
  void connect_output(int port, Edge* edge, std::vector<Pool*> pools, bool preloaded);
  /// The output's edge leads to a kState input: what it was sent last is kept here, in case it gets lost.
  void keep_newest(int port) { outputs_[static_cast<size_t>(port)].keeps_newest = keeps_newest_ = true; }
  /// What goes wrong here.
  void set_faults(std::unique_ptr<LinkFaults> faults) { faults_ = std::move(faults); }
  /// Those of the core, while it has threads; null: it works alone.
  void set_workers(Workers* workers) { workers_ = workers; }
  /// Traced, as `number`: by the recorder of the link's core.
  void set_recorder(int number, Recorder& recorder);
  /// What absences say of sets whose loss this link has counted as an error; 0 where it is not counted.
  void set_place(uint16_t place) { place_ = place; }
  void set_calls_without_room(bool value) { calls_without_room_ = value; }

  const std::string& name() const { return name_; }
  const LinkDescription& description() const { return description_; }
  Link& link() { return *link_; }
  const RunnerCounters& counters() const { return counters_; }
  bool is_source() const { return inputs_.empty(); }
  bool ended() const { return state_ == State::kEnded; }

  void enable() { state_ = State::kRunning; }
  /// Source only: the next call ends the stream. Any thread.
  void request_end() { end_requested_.store(true, std::memory_order_release); }
  /// The token of a feedback edge is lost for good: the next call goes without.
  void excuse_feedback() { feedback_excused_ = true; }
  /// Lets go of every frame held here, after the link's stop().
  void release_frames();
  /// The core starts again: states and answers that the link was given are gone.
  void restart();
  /// It waits for a state that has got lost, and asks for it again.
  bool request_lost_state();

  Waiting waiting(int64_t now_ns);
  /// Only when waiting() is ready. Returns the time at its end.
  int64_t run(int64_t now_ns);

  // In modelled time (modelled_time.h), instead of run():
  /// What a call had to do.
  struct Work {
    bool called = false;                   // the link's process()
    bool sent = false;                     // frames, on any output
    uint64_t input_px = 0, output_px = 0;  // of the pictures taken and sent
  };
  /// All of a call but its end: what it has sent stays here, and what it was given is not let go.
  Work begin_call(int64_t now_ns);
  void end_call(int64_t end_ns);
  bool in_call() const { return under_way_ == Gathered::kCall; }
  /// Of what the last call was about.
  int64_t captured_ns() const { return trigger_.captured_ns; }
  /// How long a call takes that would take so long, were nothing wrong.
  int64_t slowed_ns(int64_t duration_ns);

  /// When a source wants to be called; meaningful while it waits for kTime.
  int64_t wake_time_ns() const { return wake_at_ns_; }
  static constexpr int64_t kNever = std::numeric_limits<int64_t>::max();
  bool keeps_newest() const { return keeps_newest_; }
  /// When a state that has got lost is to be sent again; kNever where none is asked for.
  int64_t send_again_ns() const { return send_again_ns_; }

  // Call:
  const Frame& input(int port) const override { return inputs_[static_cast<size_t>(port)].frame; }
  Frame take(int port) override { return std::move(inputs_[static_cast<size_t>(port)].frame); }
  Draft create(int port) override;
  void send(int port, Draft&& draft) override { send(port, std::move(draft).publish()); }
  void send(int port, Frame&& frame) override;
  int room(int port) const override;
  int64_t now_ns() const override { return now_ns_ + clock_offset_ns(); }
  void drop(const char* reason, uint64_t count) override {
    counters_.dropped.add(reason, count);
    if (recorder_) recorder_->link_dropped(number_, reason, count);
  }
  void captured(uint64_t sets) override { counters_.captured.add(sets); }
  void wake_at(int64_t time_ns) override { wake_at_ns_ = time_ns - clock_offset_ns(); }
  void end() override { request_end(); }
  int cpus() const override { return workers_ ? workers_->cpus() : 1; }
  void run_parts(int count, Workers::Part part, const void* context) override;

 private:
  enum class State { kIdle, kRunning, kFinishing, kEnded };
  // On cache lines of their own: their neighbours in memory may belong to another core.
  struct alignas(ipc::kCacheLine) In {
    Edge* edge = nullptr;
    Intake intake = Intake::kEach;
    bool optional = false;
    bool feedback = false;
    bool ended = false;
    bool lost = false;  // kState: there is a newer one than the frame
    Frame frame;
  };
  struct alignas(ipc::kCacheLine) Out {
    Edge* edge = nullptr;
    std::vector<Pool*> pools;
    bool preloaded = false;
    bool sent = false;
    bool full = false;
    bool keeps_newest = false;
    bool requested = false;
    Frame newest;
  };
  /// What a run of the runner came to.
  enum class Gathered { kNothing, kCall, kSkip, kEnd, kFinish };
  /// Of a call's first input: sequence and times of what is made.
  struct Moment {
    uint64_t sequence = 0;
    int64_t captured_ns = 0;
    int64_t timestamp_ns = 0;
  };
  static Moment moment_of(const ipc::Message& m) { return {m.sequence, m.captured_ns, m.timestamp_ns[0]}; }

  Waiting waiting_inputs();
  Waiting waiting_outputs();
  bool has_memory(Pool& pool) const;
  bool feedback_ready(In& in);
  void absorb_states();
  void absorb_newest(In& in);
  bool fronts_are_there();
  Gathered act(int64_t now_ns);
  void let_go_of_inputs();
  void record(Gathered what, int64_t end_ns);
  uint64_t px_of(const ipc::Message& message) const;
  Gathered gather_all();
  /// Only where there is a front.
  ipc::MessageKind take_front(In& in);
  void note_loss(uint16_t lost_at);
  void gather_feedback(In& in);
  Gathered gather_any();
  void call_link();
  void finish_link();
  int64_t clock_offset_ns() const { return faults_ ? faults_->core.clock_offset_ns() : 0; }
  bool throws_as_it_sends() const;
  void throw_if_struck(uint64_t occasion);
  void take_longer(int64_t began_ns);
  bool states_requested();
  void send_requested_states();
  void count_lost_set();
  void fail(const char* what);
  void leave_absences();
  void end_outputs();
  int64_t publish_outputs();
  uint64_t frame_number() const;
  void discard_inputs();

  // What every call looks at comes first, and close together.
  State state_ = State::kIdle;
  bool calls_without_room_ = false;
  bool keeps_newest_ = false;  // of some output
  bool takes_states_ = false;  // at some input
  bool called_ = false;
  bool threw_ = false;  // the last call
  bool failed_ = false;
  bool feedback_excused_ = false;
  std::atomic<bool> end_requested_{false};
  Trigger trigger_on_;
  Gathered under_way_ = Gathered::kNothing;  // from begin_call() to end_call()
  uint16_t lost_at_ = 0;                     // of a set that goes no further
  uint16_t place_ = 0;
  int number_ = 0;  // for the recorder
  std::vector<In> inputs_;
  std::vector<Out> outputs_;
  int64_t now_ns_ = 0;
  Moment trigger_;
  std::unique_ptr<Link>& link_;
  Holder& holder_;
  const Clock& clock_;
  Workers* workers_ = nullptr;
  Recorder* recorder_ = nullptr;        // null: not traced
  std::unique_ptr<LinkFaults> faults_;  // null: nothing goes wrong
  int64_t wake_at_ns_ = 0;
  int64_t send_again_ns_ = kNever, sent_again_ns_ = 0;
  OnError on_error_;
  RunnerCounters counters_;
  std::string name_, core_;
  LinkDescription description_;
  Hooks hooks_;
};

}  // namespace svchain
