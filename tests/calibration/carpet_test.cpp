// The charts file of the real carpet against its pictures.

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/import_diy.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::calibration;

namespace {

struct Shot {
  geometry::Camera camera;
  cv::Mat grey;
};

/// The four cameras by their author's calibration, and what they saw.
std::vector<Shot> read_shots(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"front", "right", "back", "left"})
    files.push_back(folder / "yaml" / (std::string(name) + ".yaml"));
  const auto rig = geometry::import_diy(files);
  REQUIRE(rig);
  std::vector<Shot> shots;
  for (size_t i = 0; i < 4; ++i) {
    const auto picture = folder / "images" / files[i].filename().replace_extension(".png");
    shots.push_back({rig->cameras[i], cv::imread(picture.string(), cv::IMREAD_GRAYSCALE)});
    REQUIRE_FALSE(shots.back().grey.empty());
    cv::blur(shots.back().grey, shots.back().grey, {3, 3});
  }
  return shots;
}

int nearest(double place_px, int size_px) {
  return std::clamp(static_cast<int>(std::lround(place_px)), 0, size_px - 1);
}

/// Whether the camera sees the corner's surroundings dark where they are black and lighter elsewhere.
bool shows(const Shot& shot, const ChartCorner& corner) {
  constexpr double kAsideM = 0.13;
  constexpr std::array<std::array<double, 2>, 4> kQuarters = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  int darkest_light = 255;
  int lightest_dark = 0;
  for (size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d ground =
        corner.place_m + kAsideM * Eigen::Vector2d(kQuarters[k][0], kQuarters[k][1]);
    const auto pixel = shot.camera.see({ground.x(), ground.y(), 0});
    if (!pixel) return false;
    const int grey =
        shot.grey.at<uint8_t>(nearest(pixel->y(), shot.grey.rows), nearest(pixel->x(), shot.grey.cols));
    if (corner.dark >> k & 1)
      lightest_dark = std::max(lightest_dark, grey);
    else
      darkest_light = std::min(darkest_light, grey);
  }
  return lightest_dark < darkest_light;
}

}  // namespace

TEST_CASE("around every saddle of the real carpet a picture is dark where the charts file says so") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: the real data are not there");
    return;
  }
  const auto shots = read_shots(*data / "real_car_carpet");
  const auto charts = read_charts(testing::project_folder() / "configs" / "charts" / "car_carpet.json");
  REQUIRE(charts);
  int saddles = 0;
  for (const auto& corner : corners(charts->front())) {
    if (!corner.is_saddle()) continue;
    INFO("at " << corner.place_m.transpose());
    CHECK(std::any_of(shots.begin(), shots.end(), [&](const Shot& shot) { return shows(shot, corner); }));
    ++saddles;
  }
  CHECK(saddles == 108);
}
