// Where the LUT of a whole surround view comes from.

#include <future>

#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> on_toy(std::vector<std::string> overrides) {
  overrides.push_back("input=simulated:toy");
  return overrides;
}

std::string sha256(const nlohmann::json& report) {
  return report["output"]["sha256"];
}

/// Runs by hand, and tells geometric alignment to recalibrate as soon as its first LUT is in force.
nlohmann::json run_and_recalibrate(Plan plan, uint64_t frames, std::future<nlohmann::json>& answer) {
  Chain chain(std::move(plan), by_hand_options(frames));
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  chain.start();
  while (!chain.finished()) {
    if (!answer.valid() && chain.report()["links"]["synthesis"]["processed"] == 1)
      answer = chain.control("geometric_alignment", "recalibrate", {});
    if (!chain.step() && !chain.advance_clock() && !chain.excuse_lost_feedback()) break;
  }
  chain.stop();
  return chain.report();
}

}  // namespace

TEST_CASE("the stored LUT of a run gives the next run the same pixels") {
  const SurroundView world;
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "car.lut").string();
  const auto made = world.run(world.plan("2dsv_2dsp", "tda2x", {"geometric_alignment.store=" + file}), 4);
  const auto read =
      world.run(world.plan("2dsv_2dsp", "tda2x",
                           {"geometric_alignment.source=saved", "geometric_alignment.lut=" + file}),
                4);
  CHECK(made["geometric_alignment"]["source"] == "rig");
  CHECK(read["geometric_alignment"]["source"] == "saved");
  CHECK(read["lut"] == made["lut"]);
  CHECK(sha256(read) == sha256(made));
}

TEST_CASE("a surround view aligned by charts or features reports it, the same byte by byte in every run") {
  const SurroundView world;
  for (const std::string source : {"charts", "features"}) {
    const auto overrides = on_toy({"geometric_alignment.source=" + source});
    const auto report = world.run(world.plan("2dsv_2dsp", "tda2x", overrides), 2);
    CHECK(report["frames"]["delivered"] == 2);
    CHECK(report["geometric_alignment"]["source"] == source);
    CHECK(report["geometric_alignment"]["accepted"] == true);
    CHECK(report["geometric_alignment"]["overlaps"].size() == 4);
    CHECK(world.run(world.plan("2dsv_2dsp", "tda2x", overrides), 2).dump() == report.dump());
    CHECK(sha256(world.run(world.plan("2dsv_1dsp", "tda2x", overrides), 2, 7)) == sha256(report));
  }
}

TEST_CASE("told to recalibrate while running, geometric alignment sends a second LUT and no frame is lost") {
  const SurroundView world;
  std::future<nlohmann::json> answer;
  const auto report = run_and_recalibrate(
      world.plan("2dsv_2dsp", "tda2x", on_toy({"geometric_alignment.source=features"})), 6, answer);
  REQUIRE(answer.valid());
  CHECK(answer.get()["source"] == "features");
  CHECK(report["geometric_alignment"]["luts"] == 2);
  CHECK(report["geometric_alignment"]["accepted"] == true);
  CHECK(report["edges"]["geometric_alignment.lut -> synthesis.lut"]["messages"] == 2);
  CHECK(report["frames"]["delivered"] == 6);
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["outstanding_at_stop"] == 0);
  }
}

TEST_CASE("a camera that gives nothing, or a ground that shows nothing, stops an alignment with the reason") {
  const SurroundView world;
  const auto use_case =
      SurroundView::with_camera_fault("2dsv_2dsp", "right", {{"lose_from", 0}, {"lose_to", 1000}}).dump();
  const auto blind = world.run(world.plan(use_case, "tda2x", {"geometric_alignment.source=features"}), 4);
  CHECK_THAT(blind["failure"].get<std::string>(), Contains("right: no frame in the first set"));
  const auto bare = world.run(world.plan("2dsv_2dsp", "tda2x", {"geometric_alignment.source=features"}), 4);
  CHECK_THAT(bare["failure"].get<std::string>(),
             Contains("no LUT from source features: overlap front-right"));
  CHECK(bare["frames"]["delivered"] == 0);
  CHECK(bare["geometric_alignment"]["accepted"] == false);
}
