// The composite without any alignment, with the geometric one, and with both.

#include <csignal>
#include <opencv2/imgcodecs.hpp>

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A comparison of a few small frames.
Outcome compared(const std::string& input, const fs::path& output, const Arguments& more = {}) {
  Arguments arguments = {
      "compare", "--input", input, "--output", output, "--frames", "8", "--set", "view.size_px=[440,540]"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return svchain_program(arguments);
}

/// The small car park with cameras that do not see alike.
fs::path small_uneven_scene(const fs::path& folder) {
  const fs::path file = small_scene_file(folder);
  Json scene = Json::parse(read_text(file));
  scene["cameras"]["right"] = {{"gain_bgr", {0.85, 0.8, 0.85}}};
  scene["cameras"]["rear"] = {{"gain_bgr", {1.2, 1.1, 1.15}}};
  write_json(file, scene);
  return file;
}

Json figures_in(const fs::path& folder) {
  return Json::parse(read_text(folder / "figures.json"));
}

double mean_of(const Json& figures, const char* variant, const char* figure) {
  return figures["variants"][variant]["mean"][figure].get<double>();
}

bool same_picture(const fs::path& a, const fs::path& b) {
  return cv::norm(cv::imread(a), cv::imread(b), cv::NORM_INF) == 0;
}

/// That each step of the comparison made better what it is there for.
void check_steps(const fs::path& out) {
  const Json figures = figures_in(out);
  INFO(figures.dump(1));
  if (has_schema_validator()) CHECK(fits_schema("comparison", figures.dump()));
  CHECK(figures["frames"] == 8);
  CHECK_FALSE(same_picture(out / "none.png", out / "geometric.png"));
  CHECK_FALSE(same_picture(out / "geometric.png", out / "both.png"));
  CHECK(mean_of(figures, "geometric", "misalignment_px") <
        0.25 * mean_of(figures, "none", "misalignment_px"));
  CHECK(mean_of(figures, "geometric", "misalignment_px") < 0.5);
  CHECK(mean_of(figures, "both", "misalignment_px") == mean_of(figures, "geometric", "misalignment_px"));
  CHECK(mean_of(figures, "both", "difference_levels") <
        0.5 * mean_of(figures, "geometric", "difference_levels"));
  CHECK(mean_of(figures, "geometric", "difference_levels") < mean_of(figures, "none", "difference_levels"));
}

}  // namespace

TEST_CASE(
    "compare writes three pictures and figures: alignment brings overlaps together, then to one colour") {
  const TemporaryFolder folder;
  const auto scene = small_uneven_scene(folder.path());
  const auto out = folder.path() / "out";
  for (const std::string align : {"charts", "features"}) {
    CAPTURE(align);
    const auto outcome = compared("simulated:" + scene.string(), out / align, {"--align", align});
    INFO(outcome.err);
    CHECK(outcome.status == 2);  // there is no folder to make it in
    fs::create_directory(out);
    const auto again = compared("simulated:" + scene.string(), out, {"--align", align});
    INFO(again.err);
    REQUIRE(again.status == 0);
    CHECK(again.out.empty());
    CHECK_THAT(again.err, Contains("front-right") && Contains("geometric") && Contains("out: compared"));
    CHECK(count_of(out) == 4);
    CHECK(cv::imread(out / "both.png").size() == cv::Size(440, 540));
    CHECK(figures_in(out)["align"] == align);
    check_steps(out);
    fs::remove_all(out);
  }
}

TEST_CASE(
    "compare takes pictures with a nominal rig, and a rig that is calibrated already for the aligned ones") {
  const TemporaryFolder folder;
  const auto scene = small_uneven_scene(folder.path());
  const auto made = folder.path() / "made", out = folder.path() / "out";
  REQUIRE(svchain_program({"simulate", "--scene", scene, "--output", made}).status == 0);
  const auto outcome = compared((made / "images").string(), out,
                                {"--rig", made / "nominal.rig.json", "--align", made / "truth.rig.json"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  check_steps(out);

  // By charts, from a file as from the scene.
  const auto by_charts = folder.path() / "by_charts";
  const auto second = compared((made / "images").string(), by_charts,
                               {"--rig", made / "nominal.rig.json", "--charts", made / "charts.json"});
  INFO(second.err);
  REQUIRE(second.status == 0);
  CHECK(figures_in(by_charts)["align"] == "charts");
  check_steps(by_charts);
}

TEST_CASE("an alignment that is rejected fails with the run and why, and nothing is made") {
  const TemporaryFolder folder;
  write_json(folder.path() / "rig.json", small_rig());
  write_stills(folder.path() / "input");
  const auto outcome = compared((folder.path() / "input").string(), folder.path() / "out",
                                {"--rig", folder.path() / "rig.json"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("geometric: ") && Contains("no LUT from source features"));
  CHECK(count_of(folder.path()) == 2);
}

TEST_CASE("Ctrl-C ends a comparison, and nothing is made") {
  const TemporaryFolder folder;
  const auto outcome = svchain_interrupted(
      {"compare", "--input", "simulated:parking", "--output", folder.path() / "out", "--frames", "1000000000",
       "--set", "view.size_px=[220,270]"},
      SIGINT, [](const std::string& said) { return said.find("0 dropped") != std::string::npos; });
  INFO(outcome.err);
  CHECK(outcome.status == 130);
  CHECK(count_of(folder.path()) == 0);
}

TEST_CASE("what is wrong with a comparison is said at once, and nothing is made") {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "");
  const auto outcome =
      svchain_program({"compare", "--usecase", "2dsv_2ds", "--output", folder.path() / "file", "--frames",
                       "0", "--align", "chart", "--charts", "garage"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--usecase: error:") && Contains("did you mean \"2dsv_2dsp\"?"));
  CHECK_THAT(outcome.err, Contains("--output: error:") && Contains("is a file"));
  CHECK_THAT(outcome.err, Contains("--frames: error:"));
  CHECK_THAT(outcome.err,
             Contains("--align: error: expected charts, features or a rig file, got \"chart\"") &&
                 Contains("did you mean \"charts\"?"));
  CHECK(count_of(folder.path()) == 1);

  const auto nothing = svchain_program({"compare"});
  CHECK(nothing.status == 2);
  CHECK_THAT(nothing.err, Contains("--output: error: expected a folder"));

  fs::create_directory(folder.path() / "full");
  write_text(folder.path() / "full" / "file", "");
  const auto full =
      compared("simulated:parking", folder.path() / "full",
               {"--align", "features", "--charts", "garage", "--set", "geometric_alignment.source=saved",
                "--set", "photometric_alignment.enabled=true"});
  CHECK(full.status == 2);
  CHECK_THAT(full.err,
             Contains("is not empty") && Contains("goes with --align charts, got --align features"));
  CHECK_THAT(full.err, Contains("--set geometric_alignment.source=saved: error: compare decides") &&
                           Contains("--set photometric_alignment.enabled=true: error: compare decides"));
}

TEST_CASE("compare refuses live cameras, rigs that cannot be read, and use cases without what it compares") {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto live =
      compared("front=/dev/video0,right=/dev/video1,rear=/dev/video2,left=/dev/video3", out,
               {"--rig", project_folder() / "configs/rigs/car.json", "--align", folder.path() / "none.json"});
  CHECK(live.status == 2);
  CHECK_THAT(live.err, Contains("--input: error: is live") && Contains("none.json"));

  Json use_case = shipped_use_case("2dsv_2dsp");
  use_case["links"].erase("photometric_alignment");
  Json edges = Json::array();
  for (const Json& edge : use_case["edges"])
    if (edge.dump().find("photometric_alignment") == std::string::npos) edges.push_back(edge);
  use_case["edges"] = edges;
  write_json(folder.path() / "plain.json", use_case);
  const auto plain = compared("simulated:parking", out, {"--usecase", folder.path() / "plain.json"});
  CHECK(plain.status == 2);
  CHECK_THAT(plain.err, Contains("there is no link of type photometric_alignment"));
  CHECK(count_of(folder.path()) == 1);
}
