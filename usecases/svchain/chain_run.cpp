#include "usecases/svchain/chain_run.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <set>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <thread>

#include "framework/chain/run.h"
#include "links/capture/frame_source.h"
#include "usecases/svchain/plan_use_case.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

namespace {

/// Says what the links warn of and has not been said yet.
void say_warnings(const Chain& chain, std::set<std::string>& said) {
  for (const auto& warning : chain.report().value("warnings", nlohmann::json::array())) {
    const std::string text = warning.is_string() ? warning.get<std::string>() : warning.dump();
    if (said.insert(text).second) spdlog::warn("{}", text);
  }
}

}  // namespace

void prepare_libraries() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("svchain"));
  spdlog::set_pattern("svchain: %l: %v");
  cv::setNumThreads(1);
}

Pace pace_for(const std::string& input, const RunNumbers& numbers, Faults& faults) {
  Pace pace = numbers.pace;
  if (is_live_source(input)) pace.real_time = true;
  if (!numbers.fps) pace.fps = source_fps(input).value_or(pace.fps);
  if (pace.virtual_clock && is_live_source(input)) {
    faults.push_back({"--clock", {}, {}, "a live input has a clock of its own, expected steady"});
  }
  return pace;
}

void configure(Chain& chain, Faults& faults) {
  if (const auto configured = chain.configure(); !configured) append(faults, configured.error());
  const bool said =
      std::any_of(faults.begin(), faults.end(), [](const Fault& f) { return f.file == "--rig"; });
  if (!said) append(faults, rig_faults(chain.plan().use_case));
}

void run_to_its_end(Chain& chain, HostLoop& host, const RunNumbers& numbers, const Pace& pace) {
  std::set<std::string> said;
  say_warnings(chain, said);
  if (pace.virtual_clock) {
    std::thread attending([&] { host.attend(chain, false, true); });
    run_by_hand(chain, numbers.seed);
    host.finish();
    attending.join();
  } else {
    chain.start();
    if (chain.state() == ChainState::kRunning) host.attend(chain, true, !pace.real_time);
    chain.stop();
  }
  say_warnings(chain, said);
}

void warn_of_outstanding_buffers(const Chain& chain) {
  for (const OutstandingBuffers& held : chain.outstanding()) {
    spdlog::warn("{} buffer(s) of {} did not come back from {}", held.count, held.pool, held.holder);
  }
}

}  // namespace svchain::program
