// Rigs from other programs' files.

#include "algorithms/geometry/rig.h"
#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

TEST_CASE("a format that there is not is answered with those there are, and nothing is written") {
  const TemporaryFolder folder;
  const auto outcome =
      svchain_program({"import", "kalibr", "camchain.yaml", "--output", folder.path() / "rig.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("\"kalibr\" is not available yet") && Contains("diy or lens_table_homography"));
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
