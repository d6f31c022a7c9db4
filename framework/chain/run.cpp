#include "framework/chain/run.h"

#include <random>

namespace svchain {

Failure stall_of(Chain& chain) {
  std::string what = "the chain stands still: ";
  const auto lines = chain.who_waits();
  for (size_t i = 0; i < lines.size(); ++i) what += (i ? "; " : "") + lines[i];
  return {"chain", chain.plan().use_case.name, 0, what};
}

void run_by_hand(Chain& chain, std::optional<uint64_t> seed) {
  std::mt19937_64 random(seed.value_or(0));
  Core::Choice choice;
  if (seed) choice = [&random](size_t n) { return static_cast<size_t>(random() % n); };
  chain.start();
  while (!chain.finished() && chain.state() != ChainState::kStopped) {
    if (chain.step(choice) || chain.advance_clock() || chain.excuse_lost_feedback()) continue;
    if (!chain.finished()) chain.fail(stall_of(chain));
    break;
  }
  chain.stop();
}

}  // namespace svchain
