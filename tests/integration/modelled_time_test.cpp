// The shipped use cases in modelled time: what the paper measured on its boards comes out of the cost model.

#include <cmath>

#include "framework/chain/run.h"
#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

using Json = nlohmann::json;

/// At 880 x 1080, as in the paper.
const std::vector<std::string> kFullSize = {"view.size_px=[880,1080]"};
constexpr uint64_t kFrames = 600;  // 20 s

Json run_modelled(Plan plan, ChainOptions options, std::optional<uint64_t> seed = {}) {
  options.costs = plan.soc.costs;
  Chain chain(std::move(plan), std::move(options));
  if (auto configured = chain.configure(); !configured)
    throw std::runtime_error(configured.error().front().text());
  run_by_hand(chain, seed);
  REQUIRE_FALSE(chain.failure());
  const Json report = chain.report();
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["outstanding_at_stop"] == 0);
  }
  return report;
}

/// Cameras at 30 fps, and no pixels.
ChainOptions in_real_time(uint64_t frames = kFrames) {
  ChainOptions options = by_hand_options(frames);
  options.pace.real_time = true;
  options.pace.pixels = false;
  return options;
}

double load(const Json& report, const std::string& core) {
  return report["after_power_up"]["cores"][core]["load"].get<double>();
}

uint64_t dropped(const Json& report) {
  uint64_t sum = 0;
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) sum += count.get<uint64_t>();
  return sum;
}

void require_30_fps(const Json& report) {
  const Json& after = report["after_power_up"];
  CHECK(after["dropped"] == 0);
  CHECK(after["fps"].get<double>() == Approx(30).epsilon(0.01));
  CHECK(report["frames"]["captured"] == kFrames);
  CHECK(report["frames"]["delivered"].get<uint64_t>() + dropped(report) == kFrames);
}

/// What does not speak of pixels.
Json timing_of(Json report) {
  for (const char* part : {"output", "photometric", "lut", "bowl_view", "mesh_table"}) report.erase(part);
  return report;
}

}  // namespace

TEST_CASE("2dsv_2dsp on a modelled TDA2x is the paper's table: 30 fps, synthesis 75 %, photometric 3 %") {
  const SurroundView world;
  const Json report = run_modelled(world.plan("2dsv_2dsp", "tda2x", kFullSize), in_real_time());
  require_30_fps(report);
  CHECK(load(report, "DSP2") == Approx(0.75).margin(0.005));
  CHECK(load(report, "DSP1") == Approx(0.03).margin(0.001));
  CHECK(report["links"]["geometric_alignment"]["process_ms"]["max"] == 5000.0);
  CHECK(report["links"]["geometric_alignment"]["process_ms"]["p50"] == 0.0);
  CHECK(report["links"]["synthesis"]["process_ms"]["p50"] == Approx(25).epsilon(1e-3));
  CHECK(report["after_power_up"]["first_delivery_s"] == Approx(5.03).margin(0.02));
  // Of the 5 s at 30 fps what found a place in a queue is shown afterwards, the rest is lost at the capture.
  CHECK(dropped(report) == report["frames"]["dropped"]["downstream_full"]);
  CHECK(dropped(report) == Approx(145).margin(5));
}

TEST_CASE("2dsv_1dsp on a modelled TDA2x holds 30 fps too, its DSP three quarters and a bit full") {
  const SurroundView world;
  for (const std::string soc : {"tda2x", "tda2eco"}) {
    const Json report = run_modelled(world.plan("2dsv_1dsp", soc, kFullSize), in_real_time());
    require_30_fps(report);
    CHECK(load(report, "DSP1") == Approx(0.78).margin(0.005));
    CHECK(dropped(report) == Approx(145).margin(5));
  }
}

TEST_CASE("2dsv_2dsp holds 30 fps on a modelled TDA3x, where an IPU is the host") {
  const SurroundView world;
  const Json report = run_modelled(world.plan("2dsv_2dsp", "tda3x", kFullSize), in_real_time());
  require_30_fps(report);
  CHECK(load(report, "DSP2") == Approx(0.75).margin(0.005));
}

TEST_CASE("a composite too large for its DSP drops frames at the capture, and that DSP is full") {
  const SurroundView world;
  const Json report =
      run_modelled(world.plan("2dsv_2dsp", "tda2x", {"view.size_px=[1080,1440]"}), in_real_time());
  CHECK(report["after_power_up"]["dropped"] > 0);
  CHECK(load(report, "DSP2") > 0.99);
  // 600 MHz / (15.7828 cycles * 1080 * 1440)
  CHECK(report["after_power_up"]["fps"].get<double>() == Approx(24.44).epsilon(0.01));
}

TEST_CASE("3dsv on a modelled TDA2x draws 30 fps on its SGX") {
  const SurroundView world;
  require_30_fps(run_modelled(world.plan("3dsv", "tda2x", kFullSize), in_real_time()));
}

TEST_CASE("a modelled lossless run delivers the pixels of a run without a model, in any order") {
  const SurroundView world;
  for (const std::string use_case : {"2dsv_2dsp", "2dsv_1dsp"}) {
    const std::string expected = world.run(world.plan(use_case), 12)["output"]["sha256"];
    const auto sum = [&](std::optional<uint64_t> seed) {
      const Json report = run_modelled(world.plan(use_case), by_hand_options(12), seed);
      CHECK(report["frames"]["delivered"] == 12);
      return report["output"]["sha256"].get<std::string>();
    };
    CHECK(sum({}) == expected);
    for (uint64_t seed = 0; seed < 3; ++seed) CHECK(sum(seed) == expected);
  }
}

TEST_CASE("without pixels a modelled run is the same but for what speaks of pixels") {
  const SurroundView world;
  for (const std::string use_case : {"2dsv_2dsp", "2dsv_1dsp", "2d3dsv", "3dsv_cpu"}) {
    for (const bool real_time : {false, true}) {
      ChainOptions options = by_hand_options(real_time ? 160 : 8);
      options.pace.real_time = real_time;
      const Json with = run_modelled(world.plan(use_case), options);
      options.pace.pixels = false;
      const Json without = run_modelled(world.plan(use_case), options);
      CHECK(timing_of(with) == timing_of(without));
      CHECK_FALSE(without.contains("output"));
      CHECK_FALSE(without.contains("photometric"));
    }
  }
}

TEST_CASE("modelled runs of a use case are the same to the byte") {
  const SurroundView world;
  const auto text = [&](std::optional<uint64_t> seed) {
    return run_modelled(world.plan("2dsv_2dsp", "tda2x", kFullSize), in_real_time(), seed).dump();
  };
  CHECK(text({}) == text({}));
  CHECK(text(7) == text(7));
}
