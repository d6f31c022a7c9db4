// A whole surround view on frames in YUV, and with its composite in NV12.

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "framework/chain/run.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

struct Run {
  nlohmann::json report;
  cv::Mat last;
};

Run run_to_png(const SurroundView& world, std::vector<std::string> overrides) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "last.png").string();
  overrides.push_back("output=" + file);
  Run run{world.run(world.plan("2dsv_2dsp", "tda2x", overrides), 4), {}};
  run.last = cv::imread(file);
  return run;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / (double(a.total()) * a.channels());
}

}  // namespace

TEST_CASE("a surround view on NV12 or YUYV looks as it does on BGR") {
  const SurroundView world;
  const cv::Mat expected = run_to_png(world, {}).last;
  REQUIRE(cv::mean(expected)[1] > 20);
  for (const std::vector<std::string>& overrides :
       std::vector<std::vector<std::string>>{{"capture.format=nv12"},
                                             {"capture.format=yuyv"},
                                             {"capture.format=nv12", "capture.colour=bt709_full"},
                                             {"synthesis.output_format=nv12"},
                                             {"capture.format=nv12", "synthesis.output_format=nv12",
                                              "synthesis.output_colour=bt709_limited"}}) {
    INFO(overrides.front());
    const Run got = run_to_png(world, overrides);
    CHECK(got.report["frames"]["delivered"] == 4);
    REQUIRE(got.last.size() == expected.size());
    CHECK(mean_difference(got.last, expected) < 1.2);  // the most is 1.09: chroma is shared by 2x2 pixels
  }
}

TEST_CASE("a composite in BGRX is shown as the same in BGR") {
  const SurroundView world;
  const cv::Mat expected = run_to_png(world, {}).last;
  const Run got = run_to_png(world, {"synthesis.output_format=bgrx8"});
  CHECK(got.report["frames"]["delivered"] == 4);
  CHECK(cv::norm(got.last, expected, cv::NORM_INF) == 0);
  CHECK_THROWS_WITH(
      run_to_png(world, {"synthesis.output_format=bgrx8", "synthesis.output_colour=bt709_full"}),
      Contains("goes with output_format nv12 or yuyv, but the format is bgrx8"));
}

TEST_CASE("a surround view on YUV gives the same pixels in any order and on any cores") {
  const SurroundView world;
  const std::vector<std::string> overrides = {"capture.format=nv12", "synthesis.output_format=nv12"};
  const auto sha = [&](const std::string& use_case, std::optional<uint64_t> seed) {
    const auto report = world.run(world.plan(use_case, "tda2x", overrides), 6, seed);
    for (const auto& [name, pool] : report["pools"].items()) CHECK(pool["outstanding_at_stop"] == 0);
    return report["output"]["sha256"].get<std::string>();
  };
  const std::string expected = sha("2dsv_2dsp", {});
  CHECK(sha("2dsv_1dsp", {}) == expected);
  for (uint64_t seed = 1; seed <= 4; ++seed) CHECK(sha("2dsv_2dsp", seed) == expected);
}

TEST_CASE("cameras can be aligned by charts in NV12") {
  const SurroundView world;
  const auto report = world.run(
      world.plan("2dsv_2dsp", "tda2x",
                 {"input=simulated:toy", "capture.format=nv12", "geometric_alignment.source=charts"}),
      1);
  CHECK(report["geometric_alignment"]["accepted"] == true);
  CHECK(report["frames"]["delivered"] == 1);
}

TEST_CASE("frames in YUV pass without a single allocation once a run has started") {
  const SurroundView world;
  Chain chain(world.plan("2dsv_2dsp", "tda2x",
                         {"display.sha256=true", "capture.format=yuyv", "synthesis.output_format=nv12"}),
              by_hand_options(30));
  REQUIRE(chain.configure());
  chain.start();
  while (chain.calls() < 60) chain.step() || chain.advance_clock();  // all have been called, the LUT is made
  const size_t before = allocation_count();
  for (int i = 0; i < 100; ++i) chain.step() || chain.advance_clock();
  CHECK(allocation_count() == before);
  chain.stop();
}

TEST_CASE("a link that only takes BGR says so where it would get NV12") {
  const SurroundView world;
  auto text = SurroundView::with_camera_fault("2dsv_2dsp", "left", nlohmann::json::object());
  text["links"]["thrower"] = {{"type", "thrower"}, {"core", "EVE1"}, {"params", {{"at", 4}}}};
  for (auto& edge : text["edges"])
    if (edge.is_object() && edge["from"] == "synthesis.view") edge["to"] = "thrower.in";
  text["edges"].push_back("thrower.out -> display.frames");
  CHECK_THROWS_WITH(world.run(world.plan(text.dump(), "tda2x", {"capture.format=nv12"}), 1),
                    Contains("\"capture.left\" gives nv12, \"camera_fault.in\" takes bgr8"));
  CHECK_THROWS_WITH(world.run(world.plan(text.dump(), "tda2x", {"synthesis.output_format=nv12"}), 1),
                    Contains("\"synthesis.view\" gives nv12, \"thrower.in\" takes bgr8"));
}

TEST_CASE("NV12 of a view of odd size is a fault at its place") {
  const SurroundView world;
  CHECK_THROWS_WITH(
      world.run(world.plan("2dsv_2dsp", "tda2x", {"view.size_px=[221,270]", "synthesis.output_format=nv12"}),
                1),
      Contains("nv12 needs an even width and height, the view is 221x270 px"));
}
