#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

using Json = nlohmann::json;

bool is_identity(const Json& photometric) {
  for (const auto& [camera, curves] : photometric["tone_mapping"].items())
    for (const std::string channel : {"b", "g", "r"})
      for (int v = 0; v < 256; ++v)
        if (curves[channel][static_cast<size_t>(v)] != v) return false;
  for (const auto& [camera, falloff] : photometric["falloff"].items())
    if (falloff != Json{0.0, 0.0}) return false;
  return true;
}

double difference(const Json& photometric, const char* when) {
  double sum = 0;
  for (const auto& [name, overlap] : photometric["overlaps"].items())
    sum += overlap[std::string("difference_") + when].get<double>();
  return sum / static_cast<double>(photometric["overlaps"].size());
}

/// Runs by hand and says the command once so many frames have been made.
Json run_and_say(Plan plan, uint64_t frames, const std::string& command, uint64_t after,
                 std::future<Json>& answer) {
  Chain chain(std::move(plan), by_hand_options(frames));
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  chain.start();
  while (!chain.finished()) {
    if (!answer.valid() && chain.report()["links"]["synthesis"]["processed"] == after)
      answer = chain.control("photometric_alignment", command, {});
    if (!chain.step() && !chain.advance_clock() && !chain.excuse_lost_feedback()) break;
  }
  chain.stop();
  return chain.report();
}

}  // namespace

TEST_CASE("photometric alignment says what it believed and what it left") {
  const SurroundView world;
  const Json photometric = world.run(world.plan("2dsv_2dsp"), 8)["photometric"];
  CHECK(photometric["enabled"] == true);
  CHECK(photometric["frames"] == 8);
  CHECK(photometric["frames_held"] == 0);
  CHECK(photometric["blocks"]["used"] > 10);
  REQUIRE(photometric["overlaps"].size() == 4);
  CHECK(photometric["overlaps"].contains("left-front"));
  CHECK(difference(photometric, "before") > 5);
  CHECK(difference(photometric, "after") < 2);
}

TEST_CASE("disabled, photometric alignment leaves all values as they are") {
  const SurroundView world;
  const auto report = world.run(world.plan("2dsv_2dsp", "tda2x", {"photometric_alignment.enabled=false"}), 4);
  CHECK(report["photometric"]["enabled"] == false);
  CHECK(report["photometric"]["frames"] == 0);
  CHECK(is_identity(report["photometric"]));
  CHECK(report["frames"]["delivered"] == 4);
}

TEST_CASE("photometric alignment can be switched off and on while frames go on") {
  const SurroundView world;
  std::future<Json> off, on;
  const Json disabled = run_and_say(world.plan("2dsv_2dsp"), 8, "disable", 4, off);
  CHECK(off.get()["enabled"] == false);
  CHECK(is_identity(disabled["photometric"]));
  CHECK(disabled["frames"]["delivered"] == 8);
  const Json enabled = run_and_say(world.plan("2dsv_2dsp", "tda2x", {"photometric_alignment.enabled=false"}),
                                   8, "enable", 4, on);
  CHECK(on.get()["enabled"] == true);
  CHECK(!is_identity(enabled["photometric"]));
  CHECK(enabled["frames"]["delivered"] == 8);
}

TEST_CASE("photometric alignment refuses commands that it does not know, and names those it does") {
  const SurroundView world;
  std::future<Json> answer;
  run_and_say(world.plan("2dsv_2dsp"), 4, "brighten", 2, answer);
  CHECK_THROWS_WITH(answer.get(), Contains("brighten") && Contains("enable, disable or status"));
}

TEST_CASE("without falloff wanted, none is undone") {
  const SurroundView world;
  const auto photometric = [&](std::vector<std::string> overrides) {
    overrides.push_back("input=simulated:toy");
    overrides.push_back("view.size_px=[440,540]");
    return world.run(world.plan("2dsv_2dsp", "tda2x", overrides), 4)["photometric"];
  };
  const Json with = photometric({}), without = photometric({"photometric_alignment.falloff=false"});
  CHECK(with["falloff"]["front"][0] != 0.0);
  for (const auto& [camera, falloff] : without["falloff"].items()) CHECK(falloff == Json{0.0, 0.0});
  CHECK(!is_identity(without));
}

TEST_CASE("a camera that never comes keeps its values, and the others are aligned without it") {
  const SurroundView world;
  const auto blind =
      SurroundView::with_camera_fault("2dsv_2dsp", "right", {{"lose_from", 0}, {"lose_to", 1000}});
  const Json photometric = world.run(world.plan(blind.dump()), 30)["photometric"];
  CHECK(photometric["blocks"]["rejected"]["dark"] > 10);
  REQUIRE(photometric["overlaps"].size() == 2);
  CHECK(difference(photometric, "before") > 5);
  CHECK(difference(photometric, "after") < 2);
  for (const std::string channel : {"b", "g", "r"})
    for (int v = 0; v < 256; ++v)
      CHECK(photometric["tone_mapping"]["right"][channel][static_cast<size_t>(v)] == v);
}
