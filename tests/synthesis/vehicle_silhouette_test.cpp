#include "algorithms/synthesis/vehicle_silhouette.h"

#include <opencv2/core.hpp>

#include "tests/catch.h"

using namespace svchain;
using namespace svchain::synthesis;

namespace {

struct Extent {
  double left, top, right, bottom;  // first and last pixel that is not black
};

Extent extent(const cv::Mat& picture) {
  Extent e{1e9, 1e9, -1, -1};
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      if (picture.at<cv::Vec3b>(y, x) != cv::Vec3b(0, 0, 0))
        e = {std::min<double>(e.left, x), std::min<double>(e.top, y), std::max<double>(e.right, x),
             std::max<double>(e.bottom, y)};
  return e;
}

}  // namespace

TEST_CASE("a toy, a car and a van fill their rectangles") {
  for (const geometry::Vehicle vehicle : {geometry::Vehicle{0.45, 0.2}, {4.8, 1.9}, {6.9, 2.05}}) {
    const Eigen::Vector2i size(440, 540);
    const geometry::View view{size, geometry::default_metres_per_px(vehicle, size), {0, 0}};
    const Extent e = extent(vehicle_silhouette(vehicle, view));
    const Eigen::Vector2d corner = view.pixel_from_ground({vehicle.length_m / 2, vehicle.width_m / 2});
    CHECK(e.left == Approx(corner.x()).margin(2));
    CHECK(e.top == Approx(corner.y()).margin(2));
    CHECK(e.right == Approx(size.x() - 1 - corner.x()).margin(2));
    CHECK(e.bottom == Approx(size.y() - 1 - corner.y()).margin(2));
  }
}

TEST_CASE("the silhouette is grey and the same left and right") {
  const geometry::Vehicle car{4.8, 1.9};
  const cv::Mat picture = vehicle_silhouette(car, {{201, 301}, 0.02, {0, 0}});
  cv::Mat channels[3], flipped, difference;
  cv::split(picture, channels);
  CHECK(cv::norm(channels[0], channels[1], cv::NORM_INF) == 0);
  CHECK(cv::norm(channels[0], channels[2], cv::NORM_INF) == 0);
  cv::flip(channels[0], flipped, 1);
  CHECK(cv::norm(channels[0], flipped, cv::NORM_L1) / picture.total() < 2);  // grey levels: edges only
}

TEST_CASE("the silhouette follows the view's centre, and a view beside the vehicle has none of it") {
  const geometry::Vehicle car{4.8, 1.9};
  const geometry::View middle{{300, 300}, 0.02, {0, 0}}, shifted{{300, 300}, 0.02, {0.4, -0.2}};
  const Extent a = extent(vehicle_silhouette(car, middle)), b = extent(vehicle_silhouette(car, shifted));
  CHECK(b.top - a.top == 20);
  CHECK(b.left - a.left == -10);
  CHECK(cv::countNonZero(vehicle_silhouette(car, {{300, 300}, 0.02, {50, 0}}).reshape(1)) == 0);
}
