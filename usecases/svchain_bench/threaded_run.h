#pragma once
// A chain from its plan to its end, on threads. Throws std::runtime_error where it cannot be configured or a
// link fails.

#include <future>
#include <stdexcept>
#include <utility>

#include "framework/chain/chain.h"
#include "usecases/svchain_bench/faults.h"

namespace svchain::bench {

inline void run_on_threads(Plan plan, const Pace& pace) {
  std::promise<void> finished;
  ChainOptions options;
  options.pace = pace;
  options.on_finished = [&] { finished.set_value(); };
  Chain chain(std::move(plan), std::move(options));
  value_or_throw(chain.configure());
  chain.start();
  finished.get_future().wait();
  chain.stop();
  if (const auto failure = chain.failure()) throw std::runtime_error(failure->text());
}

}  // namespace svchain::bench
