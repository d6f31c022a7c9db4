// Everything that can break, in chains on real threads.

#include <algorithm>

#include "tests/catch.h"
#include "tests/integration/faulty_run.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;

/// Faults one after the other and some of them side by side; "from_s" and "to_s" count from when all are up.
struct Breakdown {
  std::string use_case;
  Json faults;
  double lasting_s;
};

Json fault(const char* kind, const std::string& at, double from_s, double to_s, Json more = Json::object()) {
  more.update({{"kind", kind}, {"from_s", from_s}, {"to_s", to_s}});
  if (!at.empty()) more["at"] = at;
  return more;
}

const Breakdown kTwoDsps = {
    "2dsv_2dsp",
    {
        fault("dropout", "capture.left", 0.5, 1.2),
        fault("freeze", "capture.front", 0.5, 1.2),
        fault("jitter", "capture.rear", 0.5, 1.2, {{"jitter_ms", 30}}),
        fault("wrong_timestamp", "capture.right", 0.5, 1.2, {{"shift_ms", -700}}),
        fault("slow", "synthesis", 0.5, 1.2, {{"factor", 3}, {"extra_ms", 20}}),
        fault("late", "geometric_alignment.lut -> synthesis.lut", 0, 4.5, {{"late_ms", 30}}),
        fault("corrupt", "capture.left", 1.3, 2),
        fault("corrupt", "capture.right", 1.3, 2),
        fault("freeze", "capture.rear", 1.3, 2),
        fault("wrong_timestamp", "capture.front", 1.3, 2, {{"shift_ms", 5000}}),
        fault("lost", "dup.out1 -> synthesis.frames", 1.3, 1.6),
        fault("lost", "synthesis.statistics -> photometric_alignment.statistics", 1.7, 2),
        fault("throw", "sync", 2, 2.3),
        fault("throw", "synthesis", 2.4, 2.7),
        fault("throw", "photometric_alignment", 2.8, 3.1),
        fault("slow", "display", 2, 3, {{"extra_ms", 40}}),
        fault("slow", "capture", 2, 3, {{"factor", 2}}),
        fault("no_memory", "synthesis", 2.7, 2.9),
        fault("no_memory", "capture", 3.1, 3.3),
        fault("clock_step", "", 2.1, 2.6, {{"step_ms", 300}}),
        fault("clock_step", "", 3, 3.5, {{"step_ms", -1500}}),
        fault("lost", "sync.frames -> dup.in", 3.2, 3.5),
        fault("late", "capture.front -> sync.front", 3.2, 3.7, {{"late_ms", 60}}),
        fault("late", "synthesis.view -> display.frames", 3.2, 3.7, {{"late_ms", 90}}),
        fault("full", "photometric_alignment.tone_mapping -> synthesis.tone_mapping", 3.3, 3.5),
        fault("full", "dup.out0 -> geometric_alignment.frames", 3.6, 3.8),
        fault("full", "synthesis.view -> display.frames", 3.8, 4),
        fault("dropout", "capture.front", 3.6, 4.2),
        fault("jitter", "capture.right", 3.6, 4.2, {{"jitter_ms", 8}}),
        fault("halt", "DSP2", 4, 4.2),
        fault("halt", "IPU1", 4.1, 4.3),
        fault("halt", "DSP1", 4.2, 4.4),
        fault("halt", "host", 4.3, 4.5),
    },
    6.5};

const Breakdown kThreeDimensions = {
    "3dsv_cpu",
    {
        fault("dropout", "capture.rear", 0.5, 1),
        fault("freeze", "capture.left", 0.5, 1),
        fault("corrupt", "capture.front", 0.5, 1),
        fault("jitter", "capture.right", 0.5, 1, {{"jitter_ms", 20}}),
        fault("slow", "bowl_view", 0.5, 1, {{"factor", 2}}),
        fault("slow", "overlap_sampling", 0.5, 1, {{"extra_ms", 20}}),
        fault("late", "photometric_alignment.tone_mapping -> bowl_view.tone_mapping", 1, 1.5,
              {{"late_ms", 50}}),
        fault("lost", "overlap_sampling.statistics -> photometric_alignment.statistics", 1, 1.5),
        fault("lost", "dup.out2 -> bowl_view.frames", 1.5, 2),
        fault("wrong_timestamp", "capture.rear", 1, 2, {{"shift_ms", 50}}),
        fault("throw", "overlap_sampling", 1.5, 1.9),
        fault("throw", "bowl_view", 2, 2.4),
        fault("no_memory", "overlap_sampling", 2.5, 2.7),
        fault("no_memory", "bowl_view", 2.6, 2.8),
        fault("full", "bowl_view.view -> display.frames", 2.8, 3),
        fault("full", "geometric_alignment.rig -> bowl_view.rig", 2.8, 3),
        fault("clock_step", "", 2.5, 3, {{"step_ms", -400}}),
        fault("halt", "DSP2", 3, 3.2),
        fault("halt", "DSP1", 3.3, 3.5),
    },
    5.5};

FaultyRun run_of(const std::string& use_case, double lasting_s) {
  FaultyRun run;
  run.use_case = use_case;
  run.lasting_s = lasting_s;
  return run;
}

/// How long this machine takes to deliver one set: a sanitizer, and whoever else is at work, make it many
/// times longer.
double power_up_s(const SurroundView& world, const std::string& use_case) {
  return run_on_threads(world, run_of(use_case, 1.0 / 30))["wall_s"].get<double>();
}

/// The breakdown with all its times `slower` times as long; "from_s" and "to_s" count from `up_s`.
FaultyRun breaking_down(const Breakdown& breakdown, double up_s, double slower) {
  FaultyRun run = run_of(breakdown.use_case, up_s + slower * breakdown.lasting_s);
  run.faults = breakdown.faults;
  for (Json& entry : run.faults) {
    const double from_s = entry["from_s"], to_s = entry["to_s"];
    // A table is sent when all comes up, and once.
    if (from_s > 0) entry["from_s"] = up_s + slower * from_s;
    entry["to_s"] = up_s + slower * to_s;
    run.looked_at_s = std::max(run.looked_at_s, entry["to_s"].get<double>());
  }
  return run;
}

/// The faults that never struck, one a line.
std::string idle_faults(const Json& report) {
  std::string idle;
  for (const Json& struck : report["faults"]["list"]) {
    if (struck["times"] == 0) idle += struck.dump() + "\n";
  }
  return idle;
}

/// A fault strikes where a link is called, and a slow machine may call a link less often than the faults of
/// it last: then all is gone through once more, slower.
void go_through(const Breakdown& breakdown) {
  const SurroundView world;
  const double up_s = 2 * power_up_s(world, breakdown.use_case);
  std::string idle;
  for (const double slower : {1, 3, 9}) {
    const Json report = run_on_threads(world, breaking_down(breakdown, up_s, slower));
    INFO("up after " << up_s << " s, " << slower << " times slower; " << report["frames"].dump()
                     << report["faults"].dump(1));
    CHECK(report.value("failure", "") == "");
    CHECK(unbalanced(report) == "");
    idle = idle_faults(report);
    if (!idle.empty()) continue;
    CHECK(report["delivered_since"] > 0);
    return;
  }
  FAIL("these never struck:\n" << idle);
}

}  // namespace

TEST_CASE("whatever breaks in a chain on threads, every fault strikes and every frame is accounted for") {
  go_through(kTwoDsps);
}

TEST_CASE("whatever breaks in the 3D view on threads, every fault strikes and every frame is accounted for") {
  go_through(kThreeDimensions);
}
