// A calibration to look at.

#include "algorithms/calibration/calibration_pictures.h"

#include "tests/calibration/small_calibration.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::calibration;
using testing::small_calibration;

namespace {

/// The most that any pixel this near is more of this colour than of the others: 0 blue, 1 green, 2 red.
int most_of(const cv::Mat& picture, const Eigen::Vector2d& at, int channel) {
  int most = 0;
  for (int y = static_cast<int>(at.y()) - 7; y <= at.y() + 7; ++y) {
    for (int x = static_cast<int>(at.x()) - 7; x <= at.x() + 7; ++x) {
      const auto& bgr = picture.at<cv::Vec3b>(y, x);
      most = std::max(most, bgr[channel] - std::max(bgr[(channel + 1) % 3], bgr[(channel + 2) % 3]));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("each corner is marked in the colour of its state, in its own camera's picture only") {
  const Calibration made = small_calibration();
  const cv::Mat grey(720, 1280, CV_8U, cv::Scalar(90));
  const cv::Mat front = corners_picture(grey, 0, made);
  REQUIRE(front.type() == CV_8UC3);
  CHECK(most_of(front, made.corners[0].found_px, 1) > 100);
  CHECK(most_of(front, made.corners[1].found_px, 0) > 100);
  CHECK(most_of(front, made.corners[2].found_px, 2) > 100);
  const cv::Vec3b missing = front.at<cv::Vec3b>(200, 363);  // where it should be: yellow
  CHECK(missing[1] - missing[0] > 100);
  CHECK(missing[2] - missing[0] > 100);

  const cv::Mat right = corners_picture(grey, 1, made);
  for (const auto& corner : made.corners)
    CHECK(right.at<cv::Vec3b>(200, static_cast<int>(corner.found_px.x())) == cv::Vec3b(90, 90, 90));
  CHECK(grey.at<uint8_t>(200, 363) == 90);  // the picture itself is left alone
}

TEST_CASE("a line leads from a rejected corner to where it should be") {
  Calibration made = small_calibration();
  made.corners[2].predicted_px = {340, 400};
  const cv::Mat front = corners_picture(cv::Mat(720, 1280, CV_8UC3, cv::Scalar(90, 90, 90)), 0, made);
  CHECK(most_of(front, {340, 300}, 2) > 100);
}

TEST_CASE("marks grow with the picture") {
  Calibration made = small_calibration();
  made.corners.resize(1);
  made.corners[0].found_px = {1000, 550};
  const auto marked = [&](int width) {
    const cv::Mat plain(width / 2, width, CV_8UC3, cv::Scalar(90, 90, 90));
    const cv::Mat drawn = corners_picture(plain, 0, made);
    const cv::Mat row = drawn.row(550).colRange(1000, width);
    int last = 0;
    for (int x = 0; x < row.cols; ++x) {
      if (row.at<cv::Vec3b>(0, x)[1] > 150) last = x;
    }
    return last;
  };
  CHECK(marked(1280) == Approx(5).margin(1));
  CHECK(marked(5120) == Approx(22).margin(2));
}

TEST_CASE("the view of a carpet holds the vehicle and all charts that have a place, and not much more") {
  Calibration made = small_calibration();
  made.charts.push_back(made.charts.front());
  made.charts.back().vehicle_from_chart = geometry::Pose2{-4, -3, 1};
  made.charts.push_back(made.charts.front());
  made.charts.back().vehicle_from_chart.reset();
  const auto view = charts_view(made.rig.vehicle, made.charts);
  CHECK(view.size_px.maxCoeff() == 1600);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (size_t k = 0; k < 2; ++k) {
    for (const double x : {-0.75, 0.75}) {  // 5 x 4 squares of 25 cm and half a square around
      for (const double y : {-0.625, 0.625}) {
        const Eigen::Vector2d pixel =
            view.pixel_from_ground(*made.charts[k].vehicle_from_chart * Eigen::Vector2d(x, y));
        low = low.cwiseMin(pixel);
        high = high.cwiseMax(pixel);
      }
    }
  }
  CHECK(low.minCoeff() > -1);
  CHECK(high.x() < view.size_px.x());
  CHECK(high.y() < view.size_px.y());
  CHECK(low.maxCoeff() < 60);
}

TEST_CASE("the stitched picture shows the ground where the calibrated cameras see it") {
  const Calibration made = small_calibration();
  std::vector<cv::Mat> pictures;
  for (int c = 0; c < 4; ++c) pictures.emplace_back(720, 1280, CV_8U, cv::Scalar(60 + 40 * c));
  const cv::Mat stitched = stitched_picture(pictures, made);
  const auto view = charts_view(made.rig.vehicle, made.charts);
  REQUIRE(stitched.size() == cv::Size(view.size_px.x(), view.size_px.y()));
  const auto at = [&](double x_m, double y_m) {
    const Eigen::Vector2d pixel = view.pixel_from_ground({x_m, y_m});
    return stitched.at<cv::Vec3b>(cvRound(pixel.y()), cvRound(pixel.x()));
  };
  CHECK(at(3.5, 0) == cv::Vec3b(60, 60, 60));
  CHECK(at(0, 1.4) == cv::Vec3b(180, 180, 180));
}
