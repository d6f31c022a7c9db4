#include <opencv2/imgcodecs.hpp>

#include "algorithms/geometry/import_diy.h"
#include "algorithms/geometry/import_lens_table.h"
#include "tests/catch.h"
#include "tests/registration/perspectives.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::registration;

namespace {

namespace fs = std::filesystem;

std::array<cv::Mat, 4> frames_in(const fs::path& folder, const std::string& rear) {
  std::array<cv::Mat, 4> frames;
  const std::string names[4] = {"front", "right", rear, "left"};
  for (size_t i = 0; i < 4; ++i) frames[i] = cv::imread((folder / (names[i] + ".png")).string());
  return frames;
}

/// Starts like those that charts give, and like those of a measuring tape.
void check_alignment(const geometry::Rig& rig, const std::array<cv::Mat, 4>& frames,
                     const std::array<double, 4>& limits_px) {
  for (const auto& [position_m, rotation_deg] : {std::pair(0.02, 1.0), std::pair(0.03, 1.5)}) {
    for (const unsigned seed : {1U, 2U}) {
      const auto start = testing::disturbed(rig, position_m, rotation_deg, seed);
      const auto aligned = align(testing::task_of(start, frames, position_m, rotation_deg));
      INFO(rotation_deg << " degrees, seed " << seed << (aligned ? "" : aligned.error()[0].text()));
      REQUIRE(aligned);
      for (size_t a = 0; a < 4; ++a) {
        CAPTURE(a);
        CHECK(aligned->overlaps[a].inliers() >= 12);
        CHECK(aligned->overlaps[a].held_out_rms_px() < limits_px[a]);
      }
    }
  }
}

}  // namespace

TEST_CASE("a real car on its carpet: features held out agree within 2 px in every overlap") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: no real recordings here");
    return;
  }
  const fs::path set = *data / "real_car_carpet";
  std::vector<fs::path> files;
  for (const char* name : {"front", "right", "back", "left"})
    files.push_back(set / "yaml" / (std::string(name) + ".yaml"));
  const auto rig = geometry::import_diy(files);
  REQUIRE(rig);
  check_alignment(*rig, frames_in(set / "images", "back"), {2, 2, 3.5, 2});
}

TEST_CASE("a real car in its garage: features held out agree within 2 px in every overlap") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: no real recordings here");
    return;
  }
  const fs::path set = *data / "real_garage_lens_table";
  std::vector<fs::path> files = {set / "m01_distortion.txt"};
  for (const char* name : {"front", "right", "back", "left"})
    files.push_back(set / "yaml" / (std::string(name) + "1.yaml"));
  const auto rig = geometry::import_lens_table(files);
  REQUIRE(rig);
  check_alignment(*rig, frames_in(set / "chessboard", "rear"), {2, 2, 2, 2});
}
