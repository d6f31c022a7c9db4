// The 3D surround view as whole chains: what it shows beside the 2D view, how it moves, and what happens
// where there is nothing to draw it with.

#include <future>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "framework/chain/run.h"
#include "tests/catch.h"
#include "tests/has_gl.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

using Json = nlohmann::json;
using Overrides = std::vector<std::string>;

constexpr uint64_t kFrames = 5;

struct Run {
  Json report;
  cv::Mat last;
};

Run run_to_png(const SurroundView& world, const std::string& use_case, Overrides overrides,
               uint64_t frames = kFrames) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "last.png").string();
  overrides.push_back("output=" + file);
  Run run{world.run(world.plan(use_case, "tda2x", overrides), frames), {}};
  run.last = cv::imread(file);
  REQUIRE(run.report["frames"]["delivered"] == frames);
  REQUIRE_FALSE(run.last.empty());
  return run;
}

std::string sha_of(const SurroundView& world, const std::string& use_case, const Overrides& overrides,
                   std::optional<uint64_t> seed = {}) {
  return world.run(world.plan(use_case, "tda2x", overrides), kFrames, seed)["output"]["sha256"];
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  REQUIRE(a.size() == b.size());
  return cv::norm(a, b, cv::NORM_L1) / (double(a.total()) * a.channels());
}

/// Shift between two pictures of the same thing.
double registration_px(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat grey_a, grey_b;
  cv::cvtColor(a, grey_a, cv::COLOR_BGR2GRAY);
  cv::cvtColor(b, grey_b, cv::COLOR_BGR2GRAY);
  grey_a.convertTo(grey_a, CV_64F);
  grey_b.convertTo(grey_b, CV_64F);
  cv::Mat window;
  cv::createHanningWindow(window, grey_a.size(), CV_64F);
  const cv::Point2d shift = cv::phaseCorrelate(grey_a, grey_b, window);
  return std::hypot(shift.x, shift.y);
}

/// Straight down from 200 m over flat ground, at the 2D view's scale.
Overrides from_high_above(const Json& view) {
  const double height_m = view["metres_per_px"].get<double>() * view["size_px"][1].get<double>();
  const double field_of_view_deg = 2 * std::atan(height_m / 2 / 200) * 180 / M_PI;
  return {"bowl.height_m=0", "car.model=none", "bowl_view.eye_m=[0,0,200]", "bowl_view.up=[1,0,0]",
          "bowl_view.field_of_view_deg=" + std::to_string(field_of_view_deg)};
}

/// Runs a chain by hand and says a command when so many frames have been shown.
Json run_and_say(Plan plan, uint64_t frames, uint64_t after, const std::string& link,
                 const std::string& command, const Json& arguments, std::future<Json>& answer) {
  Chain chain(std::move(plan), by_hand_options(frames));
  REQUIRE(chain.configure());
  chain.start();
  while (!chain.finished()) {
    if (!answer.valid() && chain.report()["links"]["display"]["processed"] == after)
      answer = chain.control(link, command, arguments);
    if (!chain.step() && !chain.advance_clock()) break;
  }
  chain.stop();
  return chain.report();
}

std::string faults_of(const SurroundView& world, const std::string& use_case, const Overrides& overrides) {
  Chain chain(world.plan(use_case, "tda2x", overrides), by_hand_options(1));
  const auto configured = chain.configure();
  if (configured) return "";
  std::string all;
  for (const Fault& fault : configured.error()) all += fault.text() + "\n";
  return all;
}

}  // namespace

TEST_CASE("straight down from high above, a flat bowl is the 2D surround view") {
  const SurroundView world;
  const Overrides richer = {"input=simulated:parking", "view.size_px=[880,1080]"};
  const Run flat = run_to_png(world, "2dsv_2dsp", richer, 2);
  Overrides overrides = from_high_above(flat.report["view"]);
  overrides.insert(overrides.end(), richer.begin(), richer.end());
  std::vector<std::string> use_cases = {"3dsv_cpu"};
  if (has_gl()) use_cases.push_back("3dsv");
  for (const std::string& use_case : use_cases) {
    INFO(use_case);
    Run high = run_to_png(world, use_case, overrides, 2);
    // The 2D view's car is painted over, here as there.
    cv::Mat expected = flat.last.clone(), shown = high.last.clone();
    const cv::Rect car(260, 240, 360, 600);
    expected(car).setTo(0);
    shown(car).setTo(0);
    CHECK(cv::mean(expected)[1] > 20);
    CHECK(mean_difference(expected, shown) <= 1.5);
    for (const cv::Point& corner :
         {cv::Point(0, 0), cv::Point(480, 0), cv::Point(0, 840), cv::Point(480, 840)}) {
      const cv::Rect part(corner, cv::Size(400, 240));  // sizes that phase correlation takes without a border
      CHECK(registration_px(expected(part), shown(part)) <= 0.5);
    }
  }
}

TEST_CASE("the 3D view by OpenGL and by the CPU are the same picture") {
  if (!has_gl()) return;
  const SurroundView world;
  for (const char* viewpoint : {"chase", "wheel_front_left"}) {
    const Overrides overrides = {std::string("bowl_view.viewpoint=") + viewpoint};
    CHECK(mean_difference(run_to_png(world, "3dsv_cpu", overrides).last,
                          run_to_png(world, "3dsv", overrides).last) <= 2);
  }
}

TEST_CASE("a viewpoint that stands needs one LUT, one that moves a LUT for every frame") {
  const SurroundView world;
  CHECK(world.run(world.plan("3dsv_cpu", "tda2x", {"bowl_view.viewpoint=chase"}),
                  kFrames)["bowl_view"]["luts"] == 1);
  CHECK(world.run(world.plan("3dsv_cpu", "tda2x", {"bowl_view.viewpoint=orbit"}),
                  kFrames)["bowl_view"]["luts"] == kFrames);
}

TEST_CASE("the 3D view's pixels depend neither on the order of the cores nor on their CPUs") {
  const SurroundView world;
  const std::string sha = sha_of(world, "3dsv_cpu", {});
  CHECK(sha_of(world, "3dsv_cpu", {}, 7) == sha);
  CHECK(sha_of(world, "3dsv_cpu", {"cpus.DSP2=3"}) == sha);
  CHECK(sha_of(world, "3dsv_cpu", {"car.opacity=0.5"}) != sha);
}

TEST_CASE("both views of one capture: the left one is the 2D surround view, pixel for pixel") {
  const SurroundView world;
  const Run alone = run_to_png(world, "2dsv_2dsp", {});
  std::vector<std::string> use_cases = {"2d3dsv_cpu"};
  if (has_gl()) use_cases.push_back("2d3dsv");
  for (const std::string& use_case : use_cases) {
    INFO(use_case);
    const Run both = run_to_png(world, use_case, {});
    REQUIRE(both.last.size() == cv::Size(440, 270));
    CHECK(cv::norm(both.last.colRange(0, 220), alone.last, cv::NORM_INF) == 0);
    CHECK(cv::mean(both.last.colRange(220, 440))[1] > 20);
  }
}

TEST_CASE("a running 3D view goes to another viewpoint within a second, without a jump") {
  const SurroundView world;
  const TemporaryFolder folder;
  const auto shown = [&](int number) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06d.png", number);
    return cv::imread((folder.path() / "shown" / name).string());
  };
  std::future<Json> answer;
  const auto report =
      run_and_say(world.plan("3dsv_cpu", "tda2x",
                             {"bowl_view.viewpoint=chase", "output=" + (folder.path() / "shown").string()}),
                  45, 5, "bowl_view", "viewpoint", {{"viewpoint", "left"}}, answer);
  REQUIRE_NOTHROW(answer.get());
  CHECK(report["frames"]["delivered"] == 45);
  const int luts = report["bowl_view"]["luts"];
  CHECK(luts > 28);  // a second's frames, and no more
  CHECK(luts <= 33);
  const Run left = run_to_png(world, "3dsv_cpu", {"bowl_view.viewpoint=left"}, 45);
  CHECK(mean_difference(shown(44), left.last) < 0.01);
  const double whole_way = mean_difference(shown(0), shown(44));
  for (int i = 0; i < 44; ++i) REQUIRE(mean_difference(shown(i), shown(i + 1)) < 0.8 * whole_way);
}

TEST_CASE("a bad viewpoint or bowl is refused while running, and the view goes on as it was") {
  const SurroundView world;
  const std::string sha = world.run(world.plan("3dsv_cpu"), 12)["output"]["sha256"];
  for (const auto& [command, arguments, why] : std::vector<std::tuple<std::string, Json, std::string>>{
           {"viewpoint", {{"viewpoint", "lft"}}, "did you mean \"left\""},
           {"viewpoint", {{"eye_m", {0, 0, 0.5}}, {"up", {1, 0, 0}}}, "inside the vehicle"},
           {"viewpoint", {{"eye_m", {9, 0, -1}}}, "below the bowl"},
           {"viewpoint", {{"eye", {9, 0, 1}}}, "eye_m"},
           {"bowl", {{"height_m", -1}, {"exponnt", 2}}, "exponent"},
           {"bowl", {{"floor_length_m", 1}}, "floor_length_m"},
           {"fly", Json::object(), "expected viewpoint or bowl"}}) {
    INFO(command << " " << arguments.dump());
    std::future<Json> answer;
    const auto report = run_and_say(world.plan("3dsv_cpu"), 12, 3, "bowl_view", command, arguments, answer);
    CHECK(report["output"]["sha256"] == sha);
    try {
      answer.get();
      FAIL("was not refused");
    } catch (const std::invalid_argument& error) {
      CHECK_THAT(error.what(), Contains(why));
    }
  }
}

TEST_CASE("the bowl changes its shape while running, and no frame is lost") {
  const SurroundView world;
  std::vector<std::pair<std::string, std::string>> by = {{"3dsv_cpu", "bowl_view"}};
  if (has_gl()) by.emplace_back("3dsv", "mesh_table");
  for (const auto& [use_case, link] : by) {
    INFO(use_case);
    const Overrides overrides = {"bowl_view.viewpoint=top"};
    std::future<Json> answer;
    const auto before = world.run(world.plan(use_case, "tda2x", overrides), 12);
    const auto report = run_and_say(world.plan(use_case, "tda2x", overrides), 12, 3, link, "bowl",
                                    {{"height_m", 0.2}, {"exponent", 3}}, answer);
    REQUIRE_NOTHROW(answer.get());
    CHECK(report["frames"]["delivered"] == 12);
    CHECK(report["output"]["sha256"] != before["output"]["sha256"]);
    if (link == "mesh_table") CHECK(report["mesh_table"]["made"] == 2);
  }
}

TEST_CASE("a mesh table is kept in a file, and made anew where it does not fit") {
  const SurroundView world;
  const TemporaryFolder folder;
  const std::string store = "mesh_table.store=" + (folder.path() / "bowl.mesh").string();
  const auto run = [&](Overrides more) {
    more.push_back(store);
    return world.run(world.plan("3dsv", "tda2x", more), kFrames);
  };
  const auto first = run({}), second = run({}), other = run({"bowl.exponent=3"});
  CHECK(first["mesh_table"]["made"] == 1);
  CHECK(second["mesh_table"]["reloaded"] == 1);
  CHECK(second["output"]["sha256"] == first["output"]["sha256"]);
  CHECK(other["mesh_table"]["made"] == 1);
  CHECK(first["mesh_table"]["bytes_per_vertex"] == 16);
}

TEST_CASE("what is wrong with bowl, car and viewpoint is said before the first frame, all at once") {
  const SurroundView world;
  const std::string faults =
      faults_of(world, "3dsv_cpu",
                {"bowl.floor_length_m=1", "bowl_view.viewpoint=chace", "car.model=/nowhere/car.glb"});
  CHECK_THAT(faults, Contains("bowl.floor_length_m") && Contains("did you mean \"chase\"") &&
                         Contains("/nowhere/car.glb"));
  CHECK_THAT(faults_of(world, "3dsv_cpu", {"bowl_view.eye_m=[0,0,-3]"}), Contains("not above the ground"));
  CHECK_THAT(faults_of(world, "3dsv_cpu", {"bowl_view.eye_m=[0.3,0,0.4]"}), Contains("inside the vehicle"));
}

TEST_CASE("3D is refused on a chip without SGX, and the chip's cores are named") {
  const SurroundView world;
  CHECK_THROWS_WITH(world.plan("3dsv", "tda3x"), Contains("no core \"SGX\""));
  CHECK_NOTHROW(world.plan("3dsv", "tda2eco"));
  CHECK_NOTHROW(world.plan("3dsv_cpu", "tda3x"));
}
