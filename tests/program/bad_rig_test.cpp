// Rigs that cannot be used.

#include <functional>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

std::string refused(const std::function<void(Json&)>& change) {
  const TemporaryFolder folder;
  Json rig = small_rig();
  change(rig);
  write_json(folder.path() / "rig.json", rig);
  write_stills(folder.path() / "input");
  const auto outcome =
      svchain_program(small_run("2dsv_2dsp", folder.path() / "rig.json", folder.path() / "input"));
  CHECK(outcome.status == 2);
  return outcome.err;
}

}  // namespace

TEST_CASE("a rig without one of the cameras is refused, naming it") {
  CHECK_THAT(refused([](Json& rig) { rig["cameras"].erase("rear"); }),
             Contains("rig.json:") && Contains("rear"));
}

TEST_CASE("a rotation that is none is refused at its place") {
  const auto said = refused([](Json& rig) {
    rig["cameras"]["left"]["vehicle_from_camera"]["quaternion_xyzw"] = {0, 0, 0, 0};
  });
  CHECK_THAT(said, Contains("/cameras/left/vehicle_from_camera/quaternion_xyzw"));
}

TEST_CASE("a fault of the rig is said once, however many links read it") {
  const auto said = refused([](Json& rig) { rig["cameras"]["left"]["lens"]["model"] = "fishy"; });
  const auto first = said.find("fishy");
  REQUIRE(first != std::string::npos);
  CHECK(said.find("fishy", first + 1) == std::string::npos);
}
