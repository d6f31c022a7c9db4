// The 3D view as a user runs it: where there is no OpenGL ES, commands while running, and bad usage.

#include <cstdlib>
#include <fstream>

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

/// While it lives, programs find no driver for OpenGL ES.
struct NoGl {
  NoGl() { setenv(kVendors, "/nowhere", 1); }
  ~NoGl() { unsetenv(kVendors); }
  static constexpr const char* kVendors = "__EGL_VENDOR_LIBRARY_DIRS";
};

struct SmallCarPark {
  TemporaryFolder folder;
  std::filesystem::path scene = small_scene_file(folder.path());

  Outcome run(const std::string& use_case, const Arguments& more) const {
    Arguments arguments = {
        "--usecase", use_case, "--input", "simulated:" + scene.string(), "--set", "view.size_px=[220,270]"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return svchain_program(arguments);
  }
};

}  // namespace

TEST_CASE("where there is no OpenGL ES the CPU draws the same, and the report says why") {
  const SmallCarPark park;
  const Arguments options = {"--frames", "3", "--output", "none", "--report", "-", "--clock", "virtual"};
  const auto by_cpu = park.run("3dsv_cpu", options);
  const NoGl none;
  const auto without = park.run("3dsv", options);
  INFO(without.err);
  REQUIRE(without.status == 0);
  const Json report = Json::parse(without.out);
  CHECK(report["bowl_view"]["renderer"] == "cpu");
  CHECK(report["bowl_view"]["by_gl"] == 0);
  CHECK_THAT(report["bowl_view"]["without_gl"].get<std::string>(), Contains("no OpenGL ES 3"));
  CHECK(report["frames"]["delivered"] == 3);
  CHECK(report["output"]["sha256"] == Json::parse(by_cpu.out)["output"]["sha256"]);
}

TEST_CASE("a user who asks for no report is warned, once, that the CPU draws the 3D view and why") {
  const SmallCarPark park;
  const std::string warning = "warning: bowl_view: the CPU draws: no OpenGL ES 3";
  const Arguments options = {"--frames", "2", "--output", "none"};
  const NoGl none;
  for (const char* clock : {"steady", "virtual"}) {
    Arguments arguments = options;
    arguments.insert(arguments.end(), {"--clock", clock});
    const auto outcome = park.run("3dsv", arguments);
    INFO(clock << ": " << outcome.err);
    CHECK(outcome.status == 0);
    const size_t said = outcome.err.find(warning);
    REQUIRE(said != std::string::npos);
    CHECK(said < outcome.err.find("frames captured"));
    CHECK(outcome.err.find(warning, said + 1) == std::string::npos);
  }
  CHECK_THAT(park.run("3dsv_cpu", options).err, !Contains("the CPU draws"));
  Arguments reported = options;
  reported.insert(reported.end(), {"--report", "-"});
  const std::string text = park.run("3dsv", reported).out;
  const Json report = Json::parse(text);
  REQUIRE(report["warnings"].size() == 1);
  CHECK_THAT(report["warnings"][0].get<std::string>(), Contains("bowl_view: the CPU draws"));
  if (has_schema_validator()) CHECK(fits_schema("report", text));
}

TEST_CASE("a run that must not do without OpenGL ES is refused where there is none") {
  const SmallCarPark park;
  const NoGl none;
  const auto outcome = park.run("3dsv", {"--set", "bowl_view.without_gl=stop", "--output", "none"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("no OpenGL ES 3"));
}

TEST_CASE("3D is refused on a chip that has no SGX") {
  const auto outcome = SmallCarPark().run("3dsv", {"--soc", "tda3x", "--output", "none"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("\"tda3x\" has no core \"SGX\""));
}

TEST_CASE("commands from a file reach the links, and bad ones are refused without harm") {
  const SmallCarPark park;
  const auto commands = park.folder.path() / "commands.txt";
  std::ofstream(commands) << "# from behind\n"
                             "bowl_view viewpoint {\"viewpoint\": \"rear\"}\n"
                             "\n"
                             "bowl_view viewpoint {\"viewpoint\": \"raer\"}\n"
                             "bowlview viewpoint\n"
                             "bowl_view\n"
                             "bowl_view bowl {\"height_m\": }\n";
  const auto outcome =
      park.run("3dsv_cpu", {"--frames", "60", "--output", "none", "--control", commands.string()});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Contains("bowl_view: viewpoint: within 1 s"));
  CHECK_THAT(outcome.err, Contains("viewpoint refused: there is no viewpoint \"raer\"") &&
                              Contains("did you mean \"rear\""));
  CHECK_THAT(outcome.err, Contains("no link \"bowlview\", did you mean \"bowl_view\""));
  CHECK_THAT(outcome.err, Contains("expected LINK COMMAND [JSON]"));
  CHECK_THAT(outcome.err, Contains("--control: bowl: "));
}

TEST_CASE("a car model or a file of commands that cannot be read is bad usage") {
  const SmallCarPark park;
  const auto model = park.folder.path() / "car.glb";
  std::ofstream(model) << "no model";
  const auto outcome = park.run("3dsv_cpu", {"--output", "none", "--set", "car.model=" + model.string(),
                                             "--control", (park.folder.path() / "nothing").string()});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains(model.string()));
  CHECK_THAT(outcome.err, Contains("--control: error: ") && Contains("cannot be read"));
}
