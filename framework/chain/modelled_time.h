#pragma once
// Modelled time: a chain as discrete events on a system on chip that need not exist. Pixels are computed all
// the same (unless Pace::pixels says no), but a call lasts as long as the cost model says:
//
//   compute = cycles / clock of the core                                   (cycles, bytes: cost_model.h)
//   memory  = bytes / bandwidth * calls in flight that move bytes, this one among them, when it begins
//   a call lasts for the longer of the two; what calls no process() (ends, absences) lasts for no time
//
// A core is busy from a call's begin to its end. At the end what the call has sent leaves, and the buffers it
// was given go home; what a link itself lets go of within the call goes home at its begin. A message is seen
// by its consumer at once on the same core, else the latency of the pair of kinds later. Cores that stand
// behind one name ("count") and CPUs that share a call ("cpus") count as one core.
//
// Order: the earliest event first; at one time first the calls that end, in the order of the SoC's cores,
// then those that begin, in the same order, on each core the link nearest to the sink. A seed picks among
// those that could begin.
//
// Power-up lasts until the first delivery, and 2 s more for the queues that it has filled to empty again; the
// report says what comes after it apart, too.
//
// Owned by its chain; the one thread that runs the chain by hand.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "framework/chain/chain.h"

namespace svchain {

class ModelledTime {
 public:
  /// All are borrowed; the runtime is complete.
  ModelledTime(const Plan& plan, const CostModel& costs, Chain::Runtime& runtime);

  /// Ends the calls whose time has come and begins one. False if none could begin.
  bool step(const Core::Choice& choice);
  /// Moves the clock to the next event. False if there is none.
  bool advance();

  /// Adds the parts "modelled" and "after_power_up".
  void report(nlohmann::json& report, int64_t end_ns) const;

 private:
  struct Priced {
    CallCost cost;
    double ns_per_cycle = 0;
    bool delivers = false;
  };
  /// The call that goes on on a core.
  struct InFlight {
    Runner* runner = nullptr;
    int64_t begin_ns = 0, end_ns = 0;
    bool moves_bytes = false;
  };
  /// How things stood when it was over.
  struct PowerUp {
    int64_t end_ns = 0;
    uint64_t dropped = 0;
    std::vector<int64_t> busy_ns;  // by core
  };

  void begin(size_t core, Runner& runner);
  void end(size_t core);
  int64_t duration_ns(const Priced& priced, const Runner::Work& work, bool& moves_bytes) const;
  void note_delivery(int64_t captured_ns);
  void end_power_up();
  nlohmann::json what_it_rests_on() const;

  const Plan& plan_;
  const CostModel& costs_;
  Chain::Runtime& runtime_;
  double view_px_ = 0;
  std::unordered_map<const Runner*, Priced> prices_;
  std::vector<InFlight> in_flight_;  // by core
  std::optional<int64_t> first_delivery_ns_;
  std::optional<PowerUp> power_up_;
  Counter delivered_after_;  // power-up
  Histogram latency_after_;  // of frames captured after it
};

/// Pixels of the composite, which calls that send tables only are counted by; 0 for a use case without one.
double view_px(const UseCase& use_case);

/// Cores in use whose clock the SoC file does not say: the chain cannot be modelled on them.
Faults what_cannot_be_modelled(const Plan& plan);

}  // namespace svchain
