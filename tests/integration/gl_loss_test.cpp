// The 3D view as a whole chain whose GL context is lost on the way.

#include "tests/gl_loss.h"

#include <opencv2/imgcodecs.hpp>

#include "framework/chain/run.h"
#include "tests/catch.h"
#include "tests/has_gl.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;
using Loss = GlLoss::Kind;

namespace {

using Json = nlohmann::json;
using Overrides = std::vector<std::string>;

constexpr int kFrames = 6, kShownBefore = 3;

/// Runs a chain by hand and loses the context when so many frames have been shown.
Json run_and_lose(Plan plan, std::optional<Loss> kind) {
  Chain chain(std::move(plan), by_hand_options(kFrames));
  REQUIRE(chain.configure());
  chain.start();
  std::optional<GlLoss> loss;
  while (!chain.finished()) {
    if (kind && !loss && chain.report()["links"]["display"]["processed"] == kShownBefore) loss.emplace(*kind);
    if (!chain.step() && !chain.advance_clock()) break;
  }
  chain.stop();
  CHECK(loss.has_value() == kind.has_value());
  Json report = chain.report();
  if (chain.failure()) report["failure"] = chain.failure()->text();
  return report;
}

/// What each frame shows.
struct Shown {
  Json report;
  std::vector<cv::Mat> frames;
};

Shown run(const SurroundView& world, const std::string& use_case, std::optional<Loss> kind = {}) {
  const TemporaryFolder folder;
  const auto shown = folder.path() / "shown";
  Shown all{run_and_lose(world.plan(use_case, "tda2x", {"output=" + shown.string()}), kind), {}};
  for (int i = 0; i < kFrames; ++i) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06d.png", i);
    all.frames.push_back(cv::imread((shown / name).string()));
    REQUIRE_FALSE(all.frames.back().empty());
  }
  return all;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0;
}

}  // namespace

TEST_CASE("a GL context that is lost in a run is made anew, and not a pixel changes") {
  if (!has_gl()) return;
  const SurroundView world;
  const Json report = run_and_lose(world.plan("3dsv"), Loss::kOnce);
  CHECK(report["output"]["sha256"] == run_and_lose(world.plan("3dsv"), {})["output"]["sha256"]);
  CHECK(report["bowl_view"]["gl_lost"] == 1);
  CHECK(report["bowl_view"]["by_gl"] == kFrames);
  CHECK_FALSE(report["bowl_view"].contains("without_gl"));
}

TEST_CASE(
    "where GL is lost for good in a run the CPU goes on with the pixels that it would have shown alone") {
  if (!has_gl()) return;
  const SurroundView world;
  const Shown by_gl = run(world, "3dsv"), by_cpu = run(world, "3dsv_cpu");
  for (const Loss kind : {Loss::kForGood, Loss::kAlways}) {
    const Shown both = run(world, "3dsv", kind);
    const Json& view = both.report["bowl_view"];
    const int drawn = view["by_gl"];  // one may have been on its way to the display
    CHECK(drawn >= kShownBefore);
    REQUIRE(drawn < kFrames);
    CHECK(view["frames"] == kFrames);
    CHECK(view["gl_lost"] == 1);
    CHECK_THAT(view["without_gl"].get<std::string>(), Contains("the context is lost"));
    REQUIRE(both.report["warnings"].size() == 1);
    CHECK_THAT(both.report["warnings"][0].get<std::string>(), Contains("bowl_view: the CPU draws"));
    CHECK(both.report["frames"]["delivered"] == kFrames);
    for (size_t i = 0; i < kFrames; ++i) {
      INFO("frame " << i << ", by GL " << drawn);
      CHECK(same(both.frames[i], (i < size_t(drawn) ? by_gl : by_cpu).frames[i]));
    }
  }
}

TEST_CASE("where the CPU must not draw a GL context that is lost for good ends the run, and says so") {
  if (!has_gl()) return;
  const SurroundView world;
  const Json report =
      run_and_lose(world.plan("3dsv", "tda2x", {"bowl_view.without_gl=stop"}), Loss::kForGood);
  REQUIRE(report.contains("failure"));
  CHECK_THAT(report["failure"].get<std::string>(),
             Contains("bowl_view") && Contains("the context is lost") && Contains("EGL_BAD_ALLOC"));
  CHECK(report["bowl_view"]["gl_lost"] == 1);
  CHECK_FALSE(report.contains("warnings"));
  CHECK(report["frames"]["delivered"] < kFrames);
}
