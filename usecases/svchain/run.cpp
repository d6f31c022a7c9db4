#include "framework/chain/run.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <thread>

#include "framework/chain/chain.h"
#include "framework/statistics/report_table.h"
#include "links/capture/frame_source.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/host_loop.h"
#include "usecases/svchain/run_numbers.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using Json = nlohmann::json;

constexpr const char* kToStdout = "-";

Faults report_faults(const std::optional<std::string>& path) {
  return path && *path != kToStdout ? check_writable(*path, "--report") : Faults{};
}

void deliver(const Json& report, const std::string& path) {
  const std::string text = report.dump(2) + "\n";
  if (path == kToStdout) {
    std::cout << text << std::flush;
  } else {
    write_whole(path, text);
  }
}

/// The sum over all pixels goes into the report, and costs time: it is formed where there is a report.
void ask_for_sums(Plan& plan) {
  for (PlannedLink& link : plan.links) {
    if (link.entry.type == "display") link.entry.parameters.put("sha256", true);
  }
}

/// The pace of the numbers, completed by what the input is.
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
  if (pace.virtual_clock) {
    std::thread attending([&] { host.attend(chain, false, true); });
    run_by_hand(chain, numbers.order_seed);
    host.finish();
    attending.join();
  } else {
    chain.start();
    if (chain.state() == ChainState::kRunning) host.attend(chain, true, !pace.real_time);
    chain.stop();
  }
}

void warn_of_outstanding_buffers(const Chain& chain) {
  for (const OutstandingBuffers& held : chain.outstanding()) {
    spdlog::warn("{} buffer(s) of {} did not come back from {}", held.count, held.pool, held.holder);
  }
}

/// A report of a failed run says so, and counts what it came to.
Json report_of(const Chain& chain) {
  Json report = chain.report();
  if (const auto failure = chain.failure()) {
    report["failure"] = {{"core", failure->core},
                         {"link", failure->link},
                         {"frame", failure->sequence},
                         {"what", failure->what}};
  }
  return report;
}

/// The log goes to stderr, and OpenCV gets no threads: they would fight the cores'.
void prepare_libraries() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("svchain"));
  spdlog::set_pattern("svchain: %l: %v");
  cv::setNumThreads(1);
}

}  // namespace

int run(const RunOptions& options) {
  prepare_libraries();

  Faults faults = report_faults(options.report);
  const RunNumbers numbers = read_numbers(options, faults);
  auto planned = plan_use_case(options.use_case);
  if (!planned) {
    append(faults, planned.error());
    return say(faults);
  }
  if (numbers.order_seed && !numbers.pace.virtual_clock) {
    spdlog::warn("--seed picks the order of a virtual run: without --clock virtual it does nothing");
  }
  const Pace pace = pace_for(setting_text(planned->plan.use_case, "input"), numbers, faults);
  if (options.report) ask_for_sums(planned->plan);

  HostLoop host;
  ChainOptions chain_options;
  chain_options.pace = pace;
  chain_options.execution = pace.virtual_clock ? Execution::kByHand : Execution::kThreads;
  chain_options.on_finished = [&host] { host.finish(); };
  Chain chain(std::move(planned->plan), std::move(chain_options));
  configure(chain, faults);
  if (!faults.empty()) return say(faults);

  run_to_its_end(chain, host, numbers, pace);

  const Json report = report_of(chain);
  std::cerr << report_table(report);
  warn_of_outstanding_buffers(chain);
  if (options.report) deliver(report, *options.report);
  const auto failure = chain.failure();
  if (failure) std::cerr << "svchain: error: " << failure->text() << '\n';
  return failure ? kFailed : kDone;
}

}  // namespace svchain::program
