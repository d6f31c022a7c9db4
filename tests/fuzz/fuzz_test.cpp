// Readers of files never crash, and never refuse without saying why. Deterministic: a failure can be
// repeated.

#include <fstream>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/rig.h"
#include "framework/fault/fault_plan.h"
#include "framework/usecase/plan.h"
#include "tests/catch.h"
#include "tests/fuzz/mutation.h"
#include "tests/test_data.h"
#include "tests/usecase/expect.h"
#include "tests/usecase/fake_links.h"

namespace svchain {

namespace {

constexpr int kRuns = 7000;  // for each reader

const char* const kCamera = R"({"image_size_px":[1280,720],"lens":LENS,
    "vehicle_from_camera":{"translation_m":[2.4,0.0,0.7],"quaternion_xyzw":[-0.5,0.5,-0.5,0.5]}})";
const char* const kFisheye =
    R"({"model":"kannala_brandt","focal_px":[330.0,330.0],"centre_px":[639.5,359.5],"k":[0,0,0,0],"max_angle_deg":95})";
const char* const kTable = R"({"model":"table","angle_deg":[0,10,30,60,90],"height_mm":[0,0.3,0.9,1.6,2.1],
    "pixel_um":6.0,"centre_px":[639.5,359.5]})";

const char* const kOcam =
    R"({"model":"ocam","inverse_polynomial":[502.65,320],"affine":[1,0,0],"centre_px":[359.5,639.5]})";
const char* const kMei =
    R"({"model":"mei","xi":1.4,"focal_px":[700,710],"centre_px":[640,360],"k":[-0.2,0.05,0.001,-0.002]})";

std::string rig_text(const std::string& lens) {
  std::string camera = kCamera;
  camera.replace(camera.find("LENS"), 4, lens);
  return R"({"vehicle":{"length_m":4.8,"width_m":1.9},"cameras":{"front":)" + camera +
         ",\"right\":" + camera + ",\"rear\":" + camera + ",\"left\":" + camera + "}}";
}

std::string file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Feeds damaged texts to a reader; returns how many it refused.
template <class Reader>
int refusals(uint64_t seed, const std::vector<std::string>& texts, Reader read) {
  testing::Mutation mutation(seed);
  int refused = 0;
  for (int run = 0; run < kRuns; ++run) {
    const std::string text = mutation.next(texts);
    const auto result = read(text);
    if (result) continue;
    ++refused;
    const bool explained = !result.error().empty() && !result.error().front().message.empty();
    if (explained) continue;
    INFO("run " << run << " of seed " << seed << ":\n" << text);
    FAIL("refused without a reason");
  }
  return refused;
}

}  // namespace

TEST_CASE("damaged use cases are read or refused with a reason, and so are their plans") {
  const Catalogue catalogue = testing::fake_catalogue();
  const Soc soc = testing::small_soc();
  const std::vector<std::string> texts = {
      testing::kTwoDsps,
      testing::text_of(
          {R"("a": {"type": "capture", "core": "IPU1"})", R"("b": {"type": "null", "core": "host"})"},
          {R"({"from": "a.front", "to": "b.in", "depth": 4, "policy": "latest"})"})};
  const int refused = refusals(1, texts, [&](const std::string& text) -> Result<Plan> {
    auto use_case = parse_use_case(text, "t.json", catalogue);
    if (!use_case) return tl::unexpected(use_case.error());
    auto plan = make_plan(std::move(*use_case), soc, catalogue);
    if (plan) graph_svg(*plan);
    return plan;
  });
  CHECK(refused > kRuns / 2);
}

TEST_CASE("damaged --set texts are applied or refused with a reason") {
  const Catalogue catalogue = testing::fake_catalogue();
  const int refused =
      refusals(2, {"synthesis.kernel=portable", "view.size_px=[440,540]", "sync.delta_ms=20", "output=a.png"},
               [&](const std::string& text) {
                 return parse_use_case(testing::kTwoDsps, "t.json", catalogue, {{text}});
               });
  CHECK(refused > kRuns / 2);
}

TEST_CASE("damaged SoC files are read or refused with a reason") {
  const auto socs = testing::project_folder() / "configs" / "socs";
  const int refused = refusals(3, {file(socs / "tda2x.json"), file(socs / "tda3x.json")},
                               [](const std::string& text) { return parse_soc(text, "s.json"); });
  CHECK(refused > kRuns / 2);
}

TEST_CASE("damaged fault files are read or refused with a reason, and so are their plans") {
  const auto faults = testing::project_folder() / "configs" / "faults";
  const std::vector<std::string> texts = {
      file(faults / "failing_parts.json"),
      R"({"random":{"per_hour":120,"from_s":10,"to_s":3600,"lasting_s":[0.05,2],"kinds":["halt","late"]}})"};
  const auto plan = testing::plan_of(testing::kTwoDsps);
  REQUIRE(plan);
  for (const auto& text : texts) REQUIRE(parse_fault_script(text, "f.json"));
  const int refused = refusals(6, texts, [&](const std::string& text) -> Result<FaultPlan> {
    const auto script = parse_fault_script(text, "f.json");
    if (!script) return tl::unexpected(script.error());
    return place_faults(*script, *plan, 1);
  });
  CHECK(refused > kRuns / 2);
}

TEST_CASE("damaged rigs are read or refused with a reason") {
  const std::vector<std::string> texts = {rig_text(kFisheye), rig_text(kTable), rig_text(kOcam),
                                          rig_text(kMei)};
  for (const auto& text : texts) {
    const auto rig = geometry::parse_rig(text, "r.json");
    if (!rig) FAIL(rig.error().front().text());
  }
  const int refused =
      refusals(4, texts, [](const std::string& text) { return geometry::parse_rig(text, "r.json"); });
  CHECK(refused > kRuns / 2);
}

TEST_CASE(
    "damaged charts are read or refused with a reason, and what is read can be written and has corners") {
  const auto charts = testing::project_folder() / "configs" / "charts";
  const std::vector<std::string> texts = {
      file(charts / "garage.json"),
      R"({"charts":[{"name":"mat","type":"squares","side_m":0.8,"centres_m":[[0,0],[1.6,0]]}]})",
      R"({"charts":[{"name":"tags","type":"apriltag_36h11","tag_m":0.4,"tags":[{"id":0,"x_m":0,"y_m":0}]}]})"};
  for (const auto& text : texts) REQUIRE(calibration::parse_charts(text, "c.json"));
  const int refused = refusals(5, texts, [](const std::string& text) {
    const auto read = calibration::parse_charts(text, "c.json");
    if (read) {
      CHECK(calibration::parse_charts(calibration::charts_text(*read), "again.json"));
      for (const auto& chart : *read) calibration::corners(chart);
    }
    return read;
  });
  CHECK(refused > kRuns / 2);
}

}  // namespace svchain
