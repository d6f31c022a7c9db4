// Pictures of a simulated scene, and what is true of them.

#include <csignal>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/geometry/rig.h"
#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

Outcome simulated(const fs::path& scene, const fs::path& output, const Arguments& more = {}) {
  Arguments arguments = {"simulate", "--scene", scene, "--output", output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return svchain_program(arguments);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool same_bytes(const fs::path& a, const fs::path& b) {
  return read_text(a) == read_text(b);
}

}  // namespace

TEST_CASE("simulate writes a picture of each camera and all that is true of them, in formats that are read") {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto scene = small_scene_file(folder.path());
  const auto outcome = simulated(scene, out);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(files_in(out) == std::vector<fs::path>{"charts.json", "ground.png", "images/front.png",
                                               "images/left.png", "images/rear.png", "images/right.png",
                                               "nominal.rig.json", "responses.json", "truth.rig.json"});
  CHECK(count_of(folder.path()) == 3);  // nothing but the rig, the scene and the new folder
  CHECK(cv::imread(out / "images/left.png").size() == cv::Size(640, 360));
  CHECK(cv::imread(out / "ground.png").size() == cv::Size(880, 1080));

  const auto truth = svchain::geometry::read_rig(out / "truth.rig.json");
  const auto nominal = svchain::geometry::read_rig(out / "nominal.rig.json");
  const auto given = svchain::geometry::read_rig(folder.path() / "rig.json");
  REQUIRE((truth && nominal && given));
  CHECK(svchain::geometry::rig_text(*truth) == svchain::geometry::rig_text(*given));
  CHECK(svchain::geometry::rig_text(*nominal) != svchain::geometry::rig_text(*truth));

  // Charts files need a yaw, which scenes may leave out.
  CHECK(Json::parse(read_text(out / "charts.json"))["charts"] == Json::parse(read_text(scene))["charts"]);
}

TEST_CASE("the simulated pictures feed back as input and give the ideal top view") {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  REQUIRE(simulated(small_scene_file(folder.path()), out).status == 0);
  const auto outcome = svchain_program({"--usecase", "2dsv_2dsp", "--rig", out / "truth.rig.json", "--input",
                                        out / "images", "--output", folder.path() / "top.png"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  cv::Mat seen = cv::imread(folder.path() / "top.png");
  cv::Mat truth = cv::imread(out / "ground.png");
  REQUIRE(seen.size() == truth.size());
  // What the small pictures do not resolve, and the asphalt's grain, says nothing about places and colours.
  cv::GaussianBlur(seen, seen, {0, 0}, 4);
  cv::GaussianBlur(truth, truth, {0, 0}, 4);
  cv::Mat difference, mask(seen.size(), CV_8U, cv::Scalar(0));
  cv::absdiff(seen, truth, difference);
  // Around the car, near its cameras: 2.4 m to the front and the rear, 1.5 m to the sides.
  cv::rectangle(mask, {440 - 240, 540 - 480}, {440 + 240, 540 + 480}, cv::Scalar(255), cv::FILLED);
  cv::rectangle(mask, {440 - 130, 540 - 290}, {440 + 130, 540 + 290}, cv::Scalar(0), cv::FILLED);
  const cv::Scalar mean = cv::mean(difference, mask);
  for (int c = 0; c < 3; ++c) CHECK(mean[c] < 3);
  const cv::Scalar unlike = cv::mean(cv::abs(truth - cv::mean(truth, mask)), mask);
  CHECK(unlike[1] > 9);  // an even grey would not have done
}

TEST_CASE("the same seed gives the same bytes, another seed another nominal rig under the same truth") {
  const TemporaryFolder folder;
  const auto scene = small_scene_file(folder.path());
  const auto a = folder.path() / "a", b = folder.path() / "b", c = folder.path() / "c";
  REQUIRE(simulated(scene, a, {"--seed", "7"}).status == 0);
  REQUIRE(simulated(scene, b, {"--seed", "7"}).status == 0);
  REQUIRE(simulated(scene, c, {"--seed", "8"}).status == 0);
  REQUIRE(files_in(a).size() == 9);
  for (const auto& file : files_in(a)) {
    INFO(file);
    CHECK(same_bytes(a / file, b / file));
  }
  CHECK_FALSE(same_bytes(a / "nominal.rig.json", c / "nominal.rig.json"));
  CHECK(same_bytes(a / "truth.rig.json", c / "truth.rig.json"));
}

TEST_CASE("several frames become numbered pictures of a moving vehicle, which a run reads to their end") {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  REQUIRE(simulated(small_scene_file(folder.path()), out, {"--frames", "3"}).status == 0);
  for (const auto& camera : kCameras) CHECK(count_of(out / "images" / camera) == 3);
  CHECK_FALSE(same_bytes(out / "images/front/000000.png", out / "images/front/000002.png"));
  const auto outcome = svchain_program(
      small_run("2dsv_2dsp", out / "truth.rig.json", out / "images", {"--output", folder.path() / "top"}));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(count_of(folder.path() / "top") == 3);
}

TEST_CASE("responses.json has the curve of every channel of every camera as the scene says") {
  const TemporaryFolder folder;
  const auto file = small_scene_file(folder.path());
  Json scene = Json::parse(read_text(file));
  scene["cameras"]["rear"] = {{"gain_bgr", {0.5, 1, 2}}, {"gamma", 2}, {"falloff", {0.1, 0.2}}};
  write_json(file, scene);
  REQUIRE(simulated(file, folder.path() / "out").status == 0);
  const Json responses = Json::parse(read_text(folder.path() / "out/responses.json"));
  CHECK(responses.size() == 4);
  const Json& rear = responses["rear"];
  CHECK(rear["gain_bgr"] == Json({0.5, 1.0, 2.0}));
  CHECK(rear["falloff"] == Json({0.1, 0.2}));
  for (const char* channel : {"b", "g", "r"}) CHECK(rear["curve"][channel].size() == 256);
  CHECK(rear["curve"]["b"][255].get<double>() == Approx(255 * 0.25));
  CHECK(rear["curve"]["g"][100].get<double>() == Approx(255 * std::pow(100 / 255.0, 2)).margin(1e-4));
  CHECK(rear["curve"]["r"][200].get<double>() == 255);
  CHECK(responses["front"]["curve"]["g"][100].get<double>() == Approx(100));
}

TEST_CASE("a scene without charts is simulated without a charts file") {
  const TemporaryFolder folder;
  const auto file = small_scene_file(folder.path());
  Json scene = Json::parse(read_text(file));
  scene.erase("charts");
  write_json(file, scene);
  REQUIRE(simulated(file, folder.path() / "out").status == 0);
  CHECK_FALSE(fs::exists(folder.path() / "out/charts.json"));
  CHECK(files_in(folder.path() / "out").size() == 8);
}

TEST_CASE("simulate fills an empty folder, and refuses one with something in it, which stays as it was") {
  const TemporaryFolder folder;
  const auto scene = small_scene_file(folder.path());
  const auto out = folder.path() / "out";
  fs::create_directory(out);
  REQUIRE(simulated(scene, out / "").status == 0);
  const auto again = simulated(scene, out);
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Contains("--output: error:") && Contains("is not empty"));
  CHECK(files_in(out).size() == 9);
  CHECK(count_of(folder.path()) == 3);
}

TEST_CASE("what is wrong with the scene, the folder and the numbers is said at once, and nothing is made") {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "");
  const auto outcome = svchain_program(
      {"simulate", "--scene", "parkin", "--output", folder.path() / "file", "--frames", "0", "--seed", "-1"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--scene: error: unknown scene \"parkin\", did you mean \"parking\"?"));
  CHECK_THAT(outcome.err, Contains("--output: error:") && Contains("is a file"));
  CHECK_THAT(outcome.err, Contains("--frames: error:") && Contains("--seed: error:"));
  CHECK(count_of(folder.path()) == 1);

  const auto nothing = svchain_program({"simulate"});
  CHECK(nothing.status == 2);
  CHECK_THAT(nothing.err, Contains("--scene: error: missing") && Contains("--output: error: expected"));
  CHECK(simulated("parking", folder.path() / "no" / "where").status == 2);

  write_text(folder.path() / "scene.json", R"({"rig": "none.json", "sed": 1})");
  const auto faulty = simulated(folder.path() / "scene.json", folder.path() / "out");
  CHECK(faulty.status == 2);
  CHECK_THAT(faulty.err, Contains("/sed") && Contains("did you mean \"seed\"?") && Contains("none.json"));
  CHECK(count_of(folder.path()) == 2);
}
