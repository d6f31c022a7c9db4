// The whole surround view on real threads.

#include <future>

#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

nlohmann::json run_with_threads(Plan plan, ChainOptions options) {
  std::promise<void> finished;
  options.on_finished = [&] { finished.set_value(); };
  Chain chain(std::move(plan), options);
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  chain.start();
  finished.get_future().wait();
  chain.stop();
  return chain.report();
}

uint64_t accounted(const nlohmann::json& report) {
  uint64_t sum = report["frames"]["delivered"].get<uint64_t>();
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) sum += count.get<uint64_t>();
  return sum;
}

}  // namespace

TEST_CASE("threads on simulated cores deliver the pixels of the virtual run, in both partitions") {
  const SurroundView world;
  const auto expected = world.run(world.plan("2dsv_2dsp"), 30);
  for (const std::string use_case : {"2dsv_1dsp", "2dsv_2dsp"}) {
    ChainOptions options;
    options.pace.frames = 30;
    const auto report = run_with_threads(world.plan(use_case), options);
    CHECK(report["frames"] == expected["frames"]);
    CHECK(report["output"]["sha256"] == expected["output"]["sha256"]);
  }
}

TEST_CASE("synthesis on a core of several CPUs delivers the same pixels") {
  const SurroundView world;
  const auto expected = world.run(world.plan("2dsv_2dsp"), 20);
  for (const std::string cpus : {"2", "3"}) {
    ChainOptions options;
    options.pace.frames = 20;
    const auto report = run_with_threads(world.plan("2dsv_2dsp", "tda2x", {"cpus.DSP2=" + cpus}), options);
    CHECK(report["frames"] == expected["frames"]);
    CHECK(report["output"]["sha256"] == expected["output"]["sha256"]);
    CHECK(report["photometric"]["tone_mapping"] == expected["photometric"]["tone_mapping"]);
  }
}

TEST_CASE("in real time a link that is too slow makes drops appear at the capture, and no queue grows") {
  const SurroundView world;
  auto text = SurroundView::with_camera_fault("2dsv_2dsp", "front", nlohmann::json::object());
  text["links"]["slow"] = {{"type", "slow"}, {"core", "EVE1"}, {"params", {{"takes_ms", 150}}}};
  for (auto& edge : text["edges"]) {
    if (edge.is_object() && edge["from"] == "synthesis.view") edge["to"] = "slow.in";
  }
  text["edges"].push_back("slow.out -> display.frames");
  ChainOptions options;
  options.pace.real_time = true;
  options.pace.fps = 30;
  options.pace.frames = 60;
  const auto report = run_with_threads(world.plan(text.dump()), options);
  CHECK(report["frames"]["captured"] == 60);
  CHECK(accounted(report) == 60);
  CHECK(report["frames"]["delivered"].get<int>() < 40);
  const auto dropped = report["links"]["capture"]["dropped"];
  uint64_t at_capture = 0;
  for (const auto& [reason, count] : dropped.items()) at_capture += count.get<uint64_t>();
  CHECK(at_capture + report["frames"]["delivered"].get<uint64_t>() == 60);
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["high_water"].get<int>() <= pool["buffers"].get<int>());
    CHECK(pool["outstanding_at_stop"] == 0);
  }
}

TEST_CASE("in real time cameras go on while charts are found, and every set is accounted for") {
  const SurroundView world;
  ChainOptions options;
  options.pace.real_time = true;
  options.pace.fps = 30;
  options.pace.frames = 40;
  const auto report = run_with_threads(
      world.plan("2dsv_2dsp", "tda2x", {"input=simulated:toy", "geometric_alignment.source=charts"}),
      options);
  CHECK(report["geometric_alignment"]["accepted"] == true);
  CHECK(report["geometric_alignment"]["stages_ms"].size() >= 3);
  CHECK(report["frames"]["captured"] == 40);
  CHECK(accounted(report) == 40);
  CHECK(report["frames"]["delivered"].get<int>() >= 1);
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["outstanding_at_stop"] == 0);
  }
}
