#pragma once
// A link with a clock beside it: how long each of its calls takes, by what the call has to do. Pixels are
// counted as modelled time counts them (Runner::Work): of what comes in at inputs that take each frame but
// close no loop, and of what leaves where somebody listens.
//
// Takes the link's place in a plan. Belongs to the link's core while the chain runs.

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "framework/link/wrapped_link.h"
#include "framework/usecase/plan.h"

namespace svchain::program {

struct CallWork {
  bool sent = false;
  uint64_t input_px = 0, output_px = 0;  // output: of the view, where only tables are sent
  auto operator<=>(const CallWork&) const = default;
};
using CallTimes = std::map<CallWork, std::vector<int64_t>>;  // nanoseconds

class TimedLink final : public WrappedLink {
 public:
  /// The plan is looked at now, the times are added to later: borrowed.
  TimedLink(std::unique_ptr<Link> link, const Plan& plan, const PlannedLink& planned, CallTimes& times);

  void process(Call& call) override;

 private:
  std::vector<int> counted_inputs_;
  std::vector<bool> connected_;  // by output
  uint64_t view_px_ = 0;
  CallTimes& times_;
};

}  // namespace svchain::program
