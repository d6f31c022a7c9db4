#include "algorithms/calibration/single_squares.h"

#include <opencv2/imgproc.hpp>

namespace svchain::calibration {

namespace {

/// A contour of four corners whose sides and diagonals are those of a square seen a little askew.
bool is_square(const std::vector<cv::Point>& corners, double side_px) {
  constexpr double kOff = 0.35;
  if (corners.size() != 4 || !cv::isContourConvex(corners)) return false;
  for (size_t k = 0; k < 4; ++k) {
    const double side = cv::norm(corners[k] - corners[(k + 1) % 4]);
    if (std::abs(side / side_px - 1) > kOff) return false;
  }
  const double ratio = cv::norm(corners[0] - corners[2]) / cv::norm(corners[1] - corners[3]);
  return std::abs(std::log(ratio)) < kOff;
}

}  // namespace

std::vector<GroundSquare> find_single_squares(const GroundPicture& picture) {
  constexpr int kScale = 4;  // so that a contour's whole pixels are fine enough
  cv::Mat grey, large, dark;
  picture.grey.convertTo(grey, CV_8U);
  cv::resize(grey, large, {}, kScale, kScale, cv::INTER_LINEAR);
  const int neighbourhood = 2 * static_cast<int>(1.5 * kSidePx * kScale) + 1;
  cv::adaptiveThreshold(large, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, neighbourhood,
                        10);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(dark, contours, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  std::vector<GroundSquare> found;
  for (const auto& contour : contours) {
    std::vector<cv::Point> corners;
    cv::approxPolyDP(contour, corners, 0.12 * kSidePx * kScale, true);
    if (!is_square(corners, kSidePx * kScale)) continue;
    // Counter-clockwise on the ground, which has forward up and left left, as in the picture.
    if (cv::contourArea(corners, true) > 0) std::swap(corners[1], corners[3]);
    GroundSquare square;
    for (size_t k = 0; k < 4; ++k) {
      const Eigen::Vector2d pixel((corners[k].x + 0.5) / kScale - 0.5, (corners[k].y + 0.5) / kScale - 0.5);
      square[k] = picture.view.ground_from_pixel(pixel);
    }
    found.push_back(square);
  }
  return found;
}

}  // namespace svchain::calibration
