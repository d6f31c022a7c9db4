// Rigs from other programs' files.

#include "algorithms/geometry/rig.h"
#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

std::filesystem::path car() {
  return project_folder() / "configs" / "rigs" / "car.json";
}

}  // namespace

TEST_CASE("a format that there is not is answered with those there are, and nothing is written") {
  const TemporaryFolder folder;
  const auto outcome =
      svchain_program({"import", "kalibrr", "camchain.yaml", "--output", folder.path() / "rig.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("unknown format \"kalibrr\", did you mean \"kalibr\"?") && Contains("or ocam"));
  const auto exported =
      svchain_program({"export", "rose", "--rig", car(), "--output", folder.path() / "out"});
  CHECK(exported.status == 2);
  CHECK_THAT(exported.err, Contains("unknown format \"rose\", did you mean \"ros\"?"));
  CHECK(count_of(folder.path()) == 0);
}

TEST_CASE("a rig's lenses go out to Kalibr and ROS and come back as they were") {
  const TemporaryFolder folder;
  const auto kalibr =
      svchain_program({"export", "kalibr", "--rig", car(), "--output", folder.path() / "kalibr"});
  INFO(kalibr.err);
  REQUIRE(kalibr.status == 0);
  REQUIRE(svchain_program({"export", "ros", "--rig", car(), "--output", folder.path() / "ros"}).status == 0);
  CHECK(count_of(folder.path() / "ros") == 4);
  const auto a = svchain_program({"import", "kalibr", folder.path() / "kalibr" / "camchain.yaml", "--rig",
                                  car(), "--output", folder.path() / "a.json"});
  INFO(a.err);
  REQUIRE(a.status == 0);
  Arguments arguments = {"import", "ros"};
  for (const char* camera : {"front", "right", "rear", "left"}) {
    arguments.push_back(folder.path() / "ros" / (std::string(camera) + ".yaml"));
  }
  arguments.insert(arguments.end(), {"--rig", car(), "--output", folder.path() / "b.json"});
  REQUIRE(svchain_program(arguments).status == 0);
  const auto before = svchain::geometry::read_rig(car());
  REQUIRE(before);
  for (const char* name : {"a.json", "b.json"}) {
    const auto after = svchain::geometry::read_rig(folder.path() / name);
    REQUIRE(after);
    CHECK(svchain::geometry::rig_text(*after) == svchain::geometry::rig_text(*before));
  }
}

TEST_CASE("formats that know no poses ask for a nominal rig, and tell the files' faults as well") {
  const TemporaryFolder folder;
  const auto outcome =
      svchain_program({"import", "kalibr", "/nowhere/camchain.yaml", "--output", folder.path() / "rig.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("--rig: error: the format \"kalibr\"") && Contains("/nowhere/camchain.yaml"));
  const auto needless = svchain_program(
      {"import", "diy", "front.yaml", "--rig", car(), "--output", folder.path() / "rig.json"});
  CHECK(needless.status == 2);
  CHECK_THAT(needless.err, Contains("means nothing for the format \"diy\""));
  CHECK(count_of(folder.path()) == 0);
}

TEST_CASE("a canvas that the car does not fit into is refused") {
  const TemporaryFolder folder;
  const auto outcome = svchain_program({"import", "diy", "front.yaml", "--output", folder.path() / "rig.json",
                                        "--canvas-size-px", "600", "800"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--car-min-px") && Contains("rear camera"));
  CHECK(count_of(folder.path()) == 0);
}

TEST_CASE("the DIY project's calibration of a real car becomes a rig that can be read") {
  const auto data = data_folder();
  if (!data) {
    WARN("skipped: the real data are not there");
    return;
  }
  const TemporaryFolder folder;
  Arguments arguments = {"import", "diy"};
  for (const char* camera : {"front", "back", "left", "right"}) {
    arguments.push_back(*data / "real_car_carpet" / "yaml" / (std::string(camera) + ".yaml"));
  }
  arguments.insert(arguments.end(), {"--output", folder.path() / "rig.json"});
  const auto outcome = svchain_program(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto rig = svchain::geometry::read_rig(folder.path() / "rig.json");
  REQUIRE(rig);
  CHECK(rig->cameras.size() == 4);
  CHECK(count_of(folder.path()) == 1);
}
