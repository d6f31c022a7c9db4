#pragma once
// A chain: a plan brought to life. Cores with their links, pools, edges and IPC pairs; configured source to
// sink, started sink to source, drained and stopped source to sink. What may be called when: lifecycle.h; a
// call at the wrong time throws std::logic_error that names state and call.
//
// Two ways to run: threads (one for every core in use), or by hand (step()), where one thread runs all cores
// in one well-defined order, or in an order that a seed picks, under a virtual clock.
//
// Threads: all functions belong to the one controlling thread, except request_end(), finished(), failure()
// and control(), which any thread may call. The chain must outlive its threads: its destructor stops them.

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/chain/core.h"
#include "framework/chain/lifecycle.h"
#include "framework/chain/runner.h"
#include "framework/fault/fault_plan.h"
#include "framework/trace/traced_run.h"
#include "framework/usecase/plan.h"

namespace svchain {

enum class Execution { kThreads, kByHand };

struct ChainOptions {
  Pace pace;
  Execution execution = Execution::kThreads;
  /// By hand under the virtual clock: calls take the time that this says (modelled_time.h). Without it they
  /// take none.
  std::optional<CostModel> costs;
  std::chrono::milliseconds drain_deadline{10'000};
  std::optional<FaultPlan> faults;  // what breaks in this run
  size_t trace_events = 0;          // to record, on all cores together (kUsualTraceEvents); 0: no trace
  /// Called once, on some core's thread, when every link has ended.
  std::function<void()> on_finished;
};

/// A buffer that was not back in its pool when the chain stood still.
struct OutstandingBuffers {
  std::string pool;
  std::string holder;
  size_t count = 0;
};

/// How far a run has come, in sets of four.
struct Progress {
  uint64_t delivered = 0;
  uint64_t dropped = 0;
};

class Chain {
 public:
  Chain(Plan plan, ChainOptions options);
  ~Chain();
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  ChainState state() const;
  const Plan& plan() const;

  /// Configures the links, checks the formats on every edge and makes pools and edges. All faults at once;
  /// then the chain stays as it was.
  Result<void> configure();
  void start();
  /// Sources end; what was captured is delivered. Any thread.
  void request_end();
  /// Everything has been delivered (or has failed) and every link has ended. Any thread.
  bool finished() const;
  /// Drains up to the deadline, stops the links and the threads. In every state, any number of times.
  void stop();

  /// The first call that threw in a link whose policy is to stop, or what else ended the run. Any thread.
  std::optional<Failure> failure() const;
  void fail(Failure failure);

  /// Runs a command of a link on its core. The future holds the answer or the exception. Any thread; only
  /// while running.
  std::future<nlohmann::json> control(const std::string& link, const std::string& command,
                                      nlohmann::json arguments);

  /// By hand: one step of one core, `choice` picks among what is ready. False if nothing was ready anywhere.
  bool step(const Core::Choice& choice = {});
  /// By hand: moves the virtual clock to the next time a source waits for, or to the next event of modelled
  /// time. False if there is none.
  bool advance_clock();

  /// Link calls so far, on all cores: stands still when nothing goes on.
  uint64_t calls() const;
  /// A core is in the middle of a call, or held up by a fault that will be over.
  bool busy() const;
  /// Any thread, once the chain is configured.
  Progress progress() const;
  /// When nothing moves any more: lets links that wait for a lost feedback token go on without, and has lost
  /// states sent again. False if none waits so.
  bool excuse_lost_feedback();
  /// Who waits for whom, a line for every link that has not ended.
  std::vector<std::string> who_waits();

  /// After stop(): buffers that did not come back.
  std::vector<OutstandingBuffers> outstanding() const;
  /// The report of contracts.md; complete after stop().
  nlohmann::json report() const;
  /// What was recorded; complete after stop().
  TracedRun traced() const;

  struct Runtime;

 private:
  void act(ChainAction action);
  void on_core(int core, const std::function<void()>& work);
  void settle();
  std::string waiting_line(size_t link);

  Plan plan_;
  ChainOptions options_;
  std::atomic<ChainState> state_{ChainState::kCreated};
  std::unique_ptr<Runtime> runtime_;
  mutable std::mutex failure_mutex_;
  std::optional<Failure> failure_;
};

}  // namespace svchain
