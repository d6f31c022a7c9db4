#include "tests/integration/faulty_run.h"

#include <chrono>
#include <future>
#include <stdexcept>

#include "framework/chain/run.h"
#include "framework/fault/fault_plan.h"

namespace svchain::testing {

namespace {

using Json = nlohmann::json;

constexpr double kFps = 30;

Plan plan_of(const SurroundView& world, const FaultyRun& run, std::vector<std::string> overrides) {
  Plan plan = world.plan(run.use_case, "tda2x", overrides);
  for (PlannedLink& link : plan.links)
    if (run.may_throw) link.entry.on_error = OnError::kDrop;
  return plan;
}

template <class T>
T value_or_throw(Result<T> result) {
  if (result) return std::move(*result);
  throw std::runtime_error(result.error().front().text());
}

FaultPlan faults_of(const FaultyRun& run, const Plan& plan) {
  Json file;
  file["faults"] = run.faults;
  if (!run.random.is_null()) file["random"] = run.random;
  return value_or_throw(
      place_faults(value_or_throw(parse_fault_script(file.dump(), "faults.json")), plan, run.seed));
}

ChainOptions options_of(const FaultyRun& run, const Plan& plan) {
  ChainOptions options;
  options.pace.real_time = true;
  options.pace.fps = kFps;
  options.pace.frames = static_cast<uint64_t>(run.lasting_s * kFps);
  options.faults = faults_of(run, plan);
  return options;
}

Json report_of(const Chain& chain) {
  Json report = chain.report();
  if (chain.failure()) report["failure"] = chain.failure()->text();
  return report;
}

void configure(Chain& chain) {
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
}

}  // namespace

Json run_modelled(const SurroundView& world, const FaultyRun& run) {
  std::vector<std::string> overrides = {"view.size_px=[880,1080]"};
  overrides.insert(overrides.end(), run.overrides.begin(), run.overrides.end());
  Plan plan = plan_of(world, run, overrides);
  ChainOptions options = options_of(run, plan);
  options.execution = Execution::kByHand;
  options.pace.virtual_clock = true;
  options.pace.pixels = run.pixels;
  options.costs = plan.soc.costs;
  Chain chain(std::move(plan), std::move(options));
  configure(chain);
  run_by_hand(chain);
  return report_of(chain);
}

Json run_on_threads(const SurroundView& world, const FaultyRun& run) {
  Plan plan = plan_of(world, run, run.overrides);
  ChainOptions options = options_of(run, plan);
  std::promise<void> finished;
  options.on_finished = [&] { finished.set_value(); };
  Chain chain(std::move(plan), std::move(options));
  configure(chain);
  chain.start();
  const std::future<void> end = finished.get_future();
  end.wait_for(std::chrono::duration<double>(run.looked_at_s));
  const uint64_t delivered = chain.progress().delivered;
  end.wait();
  chain.stop();
  Json report = report_of(chain);
  report["delivered_since"] = report["frames"]["delivered"].get<uint64_t>() - delivered;
  return report;
}

std::string unbalanced(const Json& report) {
  std::string wrong;
  uint64_t accounted = report["frames"]["delivered"].get<uint64_t>();
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) {
    accounted += count.get<uint64_t>();
    if (reason == "unfinished") wrong += "unfinished: " + count.dump() + "; ";
  }
  if (report["frames"]["captured"] != accounted)
    wrong += "accounted for " + std::to_string(accounted) + " of " + report["frames"].dump() + "; ";
  for (const auto& [name, pool] : report["pools"].items()) {
    if (pool["outstanding_at_stop"] != 0) wrong += "buffers of " + name + " are missing; ";
  }
  return wrong;
}

}  // namespace svchain::testing
