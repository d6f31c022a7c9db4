#include "algorithms/calibration/tag_finder.h"

#include <algorithm>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/catch.h"

using namespace svchain::calibration;

namespace {

constexpr double kTagPx = 240;  // of the flat picture
constexpr double kPitchPx = 360;
const std::vector<int> kIds = {0, 42, 586};

/// Upright tags side by side, edges between pixels.
cv::Mat flat_picture() {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  cv::Mat picture(static_cast<int>(kPitchPx), static_cast<int>(kPitchPx) * 3, CV_8U, 230);
  for (size_t i = 0; i < kIds.size(); ++i) {
    cv::Mat tag;
    cv::aruco::drawMarker(dictionary, kIds[i], static_cast<int>(kTagPx), tag);
    tag.copyTo(picture(cv::Rect(static_cast<int>(i * kPitchPx) + 60, 60, tag.cols, tag.rows)));
  }
  return picture;
}

/// A tag's corners in the flat picture as tag_finder.h orders them: lower left, lower right, upper right,
/// upper left.
std::vector<cv::Point2d> flat_corners(size_t tag) {
  const double left = static_cast<double>(tag) * kPitchPx + 60 - 0.5;
  const double top = 60 - 0.5;
  return {{left, top + kTagPx}, {left + kTagPx, top + kTagPx}, {left + kTagPx, top}, {left, top}};
}

/// The largest distance in px between the corners found and where `seen_from_flat` takes the true ones; every
/// tag has to be there once.
double worst_error_px(const std::vector<FoundTag>& found, const cv::Mat& seen_from_flat) {
  double worst = 0;
  for (size_t tag = 0; tag < kIds.size(); ++tag) {
    const auto one =
        std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.id == kIds[tag]; });
    REQUIRE(one != found.end());
    std::vector<cv::Point2d> truth;
    cv::perspectiveTransform(flat_corners(tag), truth, seen_from_flat);
    for (size_t k = 0; k < 4; ++k)
      worst = std::max(worst, (one->corners_px[k] - Eigen::Vector2d(truth[k].x, truth[k].y)).norm());
  }
  CHECK(found.size() == kIds.size());
  return worst;
}

/// The flat picture's corners seen at these places, in grey.
struct Seen {
  cv::Mat picture, seen_from_flat;
};
Seen seen_at(const std::vector<cv::Point2f>& corners) {
  const cv::Mat flat = flat_picture();
  const float right = static_cast<float>(flat.cols) - 1;
  const float bottom = static_cast<float>(flat.rows) - 1;
  Seen seen;
  seen.seen_from_flat = cv::getPerspectiveTransform(
      std::vector<cv::Point2f>{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}}, corners);
  cv::warpPerspective(flat, seen.picture, seen.seen_from_flat, {1280, 960}, cv::INTER_AREA,
                      cv::BORDER_CONSTANT, 120);
  return seen;
}

}  // namespace

TEST_CASE("upright tags are found with their ids, corners from the lower left one on, counter-clockwise") {
  const cv::Mat unchanged = cv::Mat::eye(3, 3, CV_64F);
  CHECK(worst_error_px(find_tags(flat_picture()), unchanged) < 0.1);
}

TEST_CASE("tags seen in perspective are found with their corners in the tags' own order") {
  const auto ahead = seen_at({{300, 200}, {1000, 220}, {1200, 700}, {100, 640}});
  CHECK(worst_error_px(find_tags(ahead.picture), ahead.seen_from_flat) < 0.5);
  const auto turned = seen_at({{1100, 900}, {150, 850}, {250, 450}, {1000, 400}});
  CHECK(worst_error_px(find_tags(turned.picture), turned.seen_from_flat) < 0.5);
}

TEST_CASE("a mirrored picture shows no tags") {
  cv::Mat mirrored;
  cv::flip(flat_picture(), mirrored, 1);
  CHECK(find_tags(mirrored).empty());
  cv::flip(seen_at({{300, 200}, {1000, 220}, {1200, 700}, {100, 640}}).picture, mirrored, 0);
  CHECK(find_tags(mirrored).empty());
}

TEST_CASE("a picture of nothing shows no tags") {
  CHECK(find_tags(cv::Mat(480, 640, CV_8U, cv::Scalar(128))).empty());
}
