// Pictures that somebody else rendered, with the calibration they came with.

#include "usecases/svchain_accuracy/rendered_exact.h"

#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;

TEST_CASE("cameras rendered by others are found where they were, and where their file is wrong, better") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: the real data are not there");
    return;
  }
  const auto set = accuracy::read_rendered_exact(*data / "rendered_exact");
  REQUIRE(set);
  const accuracy::RenderedResult result = accuracy::calibrate_rendered(*set);
  CHECK(result.made.accepted());
  for (const size_t exact : {0, 2}) {
    const auto& camera = result.cameras[exact];
    CHECK(camera.corners == 35);
    CHECK(camera.ours_px < 0.1);
    CHECK(camera.rotation_deg < 0.05);
    CHECK(camera.translation_mm < 3);
  }
  for (const size_t wrong : {1, 3}) {
    const auto& camera = result.cameras[wrong];
    CHECK(camera.corners == 35);
    CHECK(camera.given_px > 1);
    CHECK(camera.ours_px < 0.1);
  }
}

TEST_CASE("a set whose calibration is missing is told by the file's name") {
  const testing::TemporaryFolder folder;
  const auto set = accuracy::read_rendered_exact(folder.path());
  REQUIRE_FALSE(set);
  CHECK(set.error().front().text().find("calibration.yaml") != std::string::npos);
}
