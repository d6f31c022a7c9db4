#include <opencv2/imgproc.hpp>
#include <set>

#include "algorithms/registration/brief.h"
#include "algorithms/registration/candidates.h"
#include "algorithms/registration/harris.h"
#include "algorithms/registration/patch_alignment.h"
#include "tests/catch.h"

using namespace svchain::registration;

namespace {

/// Smooth noise that repeats nowhere.
cv::Mat texture(int seed, double grain_px = 2.5, cv::Size size = {120, 100}) {
  cv::RNG random(static_cast<uint64_t>(seed));
  cv::Mat picture(size, CV_32F);
  random.fill(picture, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(picture, picture, {0, 0}, grain_px);
  return (picture - 127) * 8 + 127;
}

cv::Mat everywhere(const cv::Mat& picture) {
  return cv::Mat(picture.size(), CV_8U, cv::Scalar(255));
}

cv::Mat shifted(const cv::Mat& picture, double x, double y) {
  cv::Mat moved;
  const cv::Mat by = (cv::Mat_<double>(2, 3) << 1, 0, x, 0, 1, y);
  cv::warpAffine(picture, moved, by, picture.size(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  return moved;
}

const cv::Point kMiddle(60, 50);

}  // namespace

TEST_CASE("the strongest corners of a checkerboard are its corners, once each") {
  cv::Mat board(140, 140, CV_32F, cv::Scalar(200));
  for (int j = 0; j < 5; ++j) {
    for (int i = j % 2; i < 5; i += 2) board(cv::Rect(20 + 20 * i, 20 + 20 * j, 20, 20)) = 30;
  }
  cv::GaussianBlur(board, board, {0, 0}, 1);
  const auto corners = strongest_corners(board, everywhere(board), 16, 6);
  REQUIRE(corners.size() == 16);  // 4 x 4 inside the board, all stronger than those on its rim
  std::set<std::pair<int, int>> met;
  for (const auto& corner : corners) {
    const int i = cvRound((corner.x - 19.5) / 20), j = cvRound((corner.y - 19.5) / 20);
    CHECK((i >= 1 && i <= 4 && j >= 1 && j <= 4));
    CHECK(std::hypot(corner.x - (19.5 + 20 * i), corner.y - (19.5 + 20 * j)) < 1.5);
    met.insert({i, j});
  }
  CHECK(met.size() == 16);
}

TEST_CASE("corners are looked for only where they are allowed, and keep their distance") {
  const cv::Mat picture = texture(1, 1.5);
  cv::Mat where = cv::Mat::zeros(picture.size(), CV_8U);
  where(cv::Rect(30, 20, 50, 60)) = 255;
  const auto corners = strongest_corners(picture, where, 100, 7);
  REQUIRE(corners.size() > 5);
  for (size_t i = 0; i < corners.size(); ++i) {
    CHECK(cv::Rect(30, 20, 50, 60).contains(corners[i]));
    for (size_t k = 0; k < i; ++k) {
      const cv::Point apart = corners[i] - corners[k];
      CHECK(std::max(std::abs(apart.x), std::abs(apart.y)) > 7);
    }
  }
}

TEST_CASE("a description does not know a camera's gain and offset") {
  const cv::Mat picture = texture(2);
  const cv::Mat darker = picture * 0.4 + 20;
  const auto one = describe(picture, everywhere(picture), {kMiddle});
  const auto other = describe(darker, everywhere(picture), {kMiddle});
  CHECK(distance(one[0], other[0]) < 0.01);
}

TEST_CASE("descriptions of different places are as far apart as chance has it") {
  const auto one = describe(texture(3), everywhere(texture(3)), {kMiddle});
  const auto other = describe(texture(4), everywhere(texture(4)), {kMiddle});
  CHECK(distance(one[0], other[0]) == Approx(0.5).margin(0.2));
}

TEST_CASE("a description leaves out what is not seen, and one of next to nothing is like none") {
  const cv::Mat picture = texture(5);
  cv::Mat half = everywhere(picture), little = cv::Mat::zeros(picture.size(), CV_8U);
  half(cv::Rect(0, 0, picture.cols, kMiddle.y - 10)) = 0;
  little(cv::Rect(kMiddle.x, kMiddle.y, 5, 5)) = 255;
  cv::Mat strewn = picture.clone();
  strewn(cv::Rect(0, 0, picture.cols, kMiddle.y - 10)) =
      255;  // smoothed in, but for a few, beyond what is seen
  const auto whole = describe(picture, everywhere(picture), {kMiddle});
  const auto lower = describe(strewn, half, {kMiddle});
  const auto scrap = describe(picture, little, {kMiddle});
  CHECK(distance(whole[0], scrap[0]) == 1);
  CHECK(distance(whole[0], lower[0]) < 0.05);
}

TEST_CASE("corners are candidates for one another when they are alike, mutually, and inside the window") {
  const cv::Mat picture = texture(6);
  const auto described = describe(picture, everywhere(picture), {kMiddle, {30, 40}, {85, 60}});
  const Corners a{{{0, 0}, {1, 0}, {2, 0}}, described};
  const Corners b{{{0.1, 0}, {1.1, 0}, {9, 0}}, described};
  const std::vector<Eigen::Matrix2d> windows(3, Eigen::Matrix2d::Identity());  // 3 m each way
  const auto found = candidates(a, b, windows, 1);
  REQUIRE(found.size() == 2);
  CHECK((found[0].in_a == 0 && found[0].in_b == 0));
  CHECK((found[1].in_a == 1 && found[1].in_b == 1));
}

TEST_CASE("a patch is found again to a few hundredths of a pixel, whatever gain and offset") {
  const cv::Mat a = texture(7);
  const cv::Mat b = shifted(a, 2.25, -1.625) * 0.7 + 30;
  const Eigen::Matrix2d sharp = 0.5 * Eigen::Matrix2d::Identity();
  const auto found = aligned_patch({a, sharp}, {b, sharp}, everywhere(a), kMiddle, {1, -1});
  REQUIRE(found);
  CHECK((*found - Eigen::Vector2d(2.25, -1.625)).norm() < 0.05);
}

TEST_CASE("a corner that two cameras smear each its own way is found where it is") {
  cv::Mat corner(100, 120, CV_32F, cv::Scalar(40));
  corner(cv::Rect(kMiddle.x, kMiddle.y, 60, 50)) = 220;
  const Eigen::Matrix2d wide = Eigen::Vector2d(5, 1).asDiagonal(), tall = Eigen::Vector2d(1, 5).asDiagonal();
  cv::Mat a, b;
  cv::GaussianBlur(corner, a, {0, 0}, 3, 0.6);  // 0.6 of a camera's pixel
  cv::GaussianBlur(corner, b, {0, 0}, 0.6, 3);
  const auto found = aligned_patch({a, wide}, {b, tall}, everywhere(a), kMiddle, {0, 0});
  REQUIRE(found);
  CHECK(found->norm() < 0.1);
  const Eigen::Matrix2d sharp = 0.01 * Eigen::Matrix2d::Identity();
  const auto misled = aligned_patch({a, sharp}, {b, sharp}, everywhere(a), kMiddle, {0, 0});
  CHECK((!misled || misled->norm() > 0.3));
}

TEST_CASE("a patch along an edge, on even ground, beyond what is seen or unlike is not aligned") {
  const Eigen::Matrix2d sharp = 0.5 * Eigen::Matrix2d::Identity();
  cv::Mat edge(100, 120, CV_32F, cv::Scalar(40));
  edge(cv::Rect(0, 0, kMiddle.x, 100)) = 200;
  const cv::Mat even(100, 120, CV_32F, cv::Scalar(90)), one = texture(8), other = texture(9);
  cv::Mat seen = everywhere(one);
  CHECK(aligned_patch({one, sharp}, {one, sharp}, seen, kMiddle, {0, 0}));
  CHECK_FALSE(aligned_patch({edge, sharp}, {edge, sharp}, seen, kMiddle, {0, 0}));
  CHECK_FALSE(aligned_patch({even, sharp}, {even, sharp}, seen, kMiddle, {0, 0}));
  CHECK_FALSE(aligned_patch({one, sharp}, {other, sharp}, seen, kMiddle, {0, 0}));
  seen(cv::Rect(0, 0, kMiddle.x - 5, 100)) = 0;
  CHECK_FALSE(aligned_patch({one, sharp}, {one, sharp}, seen, kMiddle, {0, 0}));
}
