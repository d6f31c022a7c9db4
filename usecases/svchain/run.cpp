#include <iostream>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "framework/fault/fault_script.h"
#include "framework/statistics/report_table.h"
#include "framework/trace/chrome_trace.h"
#include "usecases/svchain/chain_run.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"
#include "usecases/svchain/shipped_files.h"
#include "usecases/svchain/whole_file.h"

namespace svchain::program {

namespace {

using Json = nlohmann::json;

constexpr const char* kToStdout = "-";

Faults report_faults(const std::optional<std::string>& path) {
  return path && *path != kToStdout ? check_writable(*path, "--report") : Faults{};
}

Faults trace_faults(const std::optional<std::string>& path) {
  return path ? check_writable(*path, "--trace") : Faults{};
}

Faults control_faults(HostLoop& host, const std::string& path) {
  try {
    host.take_commands(path);
    return {};
  } catch (const std::runtime_error& error) {
    return {{"--control", {}, {}, error.what()}};
  }
}

std::optional<FaultScript> read_script(const std::string& name_or_file, Faults& faults) {
  const auto file = find_file(kFaultScripts, name_or_file);
  if (!file) {
    faults.push_back({"--faults", {}, {}, file.error().front().message});
    return std::nullopt;
  }
  auto script = read_fault_script(*file);
  if (!script) append(faults, script.error());
  return script ? std::optional(*std::move(script)) : std::nullopt;
}

/// None where none were asked for, or something is wrong with them.
std::optional<FaultPlan> placed(const std::optional<FaultScript>& script, const Plan& plan,
                                const RunNumbers& numbers, Faults& faults) {
  if (!script) return std::nullopt;
  auto placed = place_faults(*script, plan, numbers.seed.value_or(1));
  if (!placed) append(faults, placed.error());
  return placed ? std::optional(*std::move(placed)) : std::nullopt;
}

void deliver(const Json& report, const std::string& path) {
  const std::string text = report.dump(2) + "\n";
  if (path == kToStdout) {
    std::cout << text << std::flush;
  } else {
    write_whole(path, text);
  }
}

void deliver_trace(const Chain& chain, const std::string& path) {
  const TracedRun traced = chain.traced();
  uint64_t lost = 0;
  for (const Recorder* recorder : traced.recorders) lost += recorder->lost();
  if (lost > 0) spdlog::warn("the trace is full: the last {} events of the run are not in {}", lost, path);
  write_whole(path, chrome_trace(traced));
}

/// The sum over all pixels goes into the report, and costs time: it is formed where there is a report.
void ask_for_sums(Plan& plan) {
  for (PlannedLink& link : plan.links) {
    if (link.entry.type == "display") link.entry.parameters.put("sha256", true);
  }
}

/// What there is to deliver without pixels.
Faults output_faults(const UseCase& use_case, const Pace& pace) {
  const std::string output = setting_text(use_case, "output");
  if (pace.pixels || output.empty() || output == "none") return {};
  return {{"--no-pixels", {}, {}, "there is nothing to write to \"" + output + "\", expected --output none"}};
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

}  // namespace

int run(const RunOptions& options) {
  prepare_libraries();

  Faults faults = report_faults(options.report);
  append(faults, trace_faults(options.trace));
  const RunNumbers numbers = read_numbers(options, faults);
  std::optional<FaultScript> script;
  if (options.faults) script = read_script(*options.faults, faults);
  auto planned = plan_use_case(options.use_case);
  if (!planned) {
    append(faults, planned.error());
    return say(faults);
  }
  if (numbers.seed && !numbers.pace.virtual_clock && !options.faults) {
    spdlog::warn("--seed picks the order of a virtual run: without --clock virtual it does nothing");
  }
  const Pace pace = pace_for(setting_text(planned->plan.use_case, "input"), numbers, faults);
  append(faults, output_faults(planned->plan.use_case, pace));
  if (options.report) ask_for_sums(planned->plan);

  HostLoop host;
  if (options.control) append(faults, control_faults(host, *options.control));
  ChainOptions chain_options;
  chain_options.pace = pace;
  chain_options.execution = pace.virtual_clock ? Execution::kByHand : Execution::kThreads;
  chain_options.faults = placed(script, planned->plan, numbers, faults);
  if (options.trace) chain_options.trace_events = kUsualTraceEvents;
  if (pace.virtual_clock) chain_options.costs = planned->plan.soc.costs;
  chain_options.on_finished = [&host] { host.finish(); };
  Chain chain(std::move(planned->plan), std::move(chain_options));
  configure(chain, faults);
  if (!faults.empty()) return say(faults);

  run_to_its_end(chain, host, numbers, pace);

  const Json report = report_of(chain);
  std::cerr << report_table(report);
  warn_of_outstanding_buffers(chain);
  if (options.report) deliver(report, *options.report);
  if (options.trace) deliver_trace(chain, *options.trace);
  const auto failure = chain.failure();
  if (failure) std::cerr << "svchain: error: " << failure->text() << '\n';
  return failure ? kFailed : kDone;
}

}  // namespace svchain::program
