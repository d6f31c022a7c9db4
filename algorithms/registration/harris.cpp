#include "algorithms/registration/harris.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace svchain::registration {

namespace {

constexpr double kWindowPx = 2;  // standard deviation of the Gaussian: a square window's answer is flat
constexpr double kHarris = 0.06;

/// det M - k trace^2 M of the structure tensor M.
cv::Mat harris(const cv::Mat& picture) {
  cv::Mat x, y;
  cv::Sobel(picture, x, CV_32F, 1, 0);
  cv::Sobel(picture, y, CV_32F, 0, 1);
  cv::Mat xx = x.mul(x), xy = x.mul(y), yy = y.mul(y);
  for (cv::Mat* product : {&xx, &xy, &yy}) cv::GaussianBlur(*product, *product, {0, 0}, kWindowPx);
  const cv::Mat trace = xx + yy;
  return xx.mul(yy) - xy.mul(xy) - kHarris * trace.mul(trace);
}

}  // namespace

std::vector<cv::Point> strongest_corners(const cv::Mat& picture, const cv::Mat& where, size_t most,
                                         int spacing_px) {
  const cv::Mat response = harris(picture);
  cv::Mat highest;
  const int width = 2 * spacing_px + 1;
  cv::dilate(response, highest, cv::getStructuringElement(cv::MORPH_RECT, {width, width}));
  std::vector<cv::Point> corners;
  for (int j = 0; j < response.rows; ++j) {
    const auto* r = response.ptr<float>(j);
    const auto* h = highest.ptr<float>(j);
    const auto* w = where.ptr<uint8_t>(j);
    for (int i = 0; i < response.cols; ++i) {
      if (w[i] && r[i] > 0 && r[i] == h[i]) corners.emplace_back(i, j);
    }
  }
  std::sort(corners.begin(), corners.end(), [&](const cv::Point& one, const cv::Point& other) {
    const float a = response.at<float>(one), b = response.at<float>(other);
    return a != b ? a > b : std::pair(one.y, one.x) < std::pair(other.y, other.x);
  });
  std::vector<cv::Point> chosen;
  for (const auto& corner : corners) {
    if (chosen.size() == most) break;
    const bool crowded = std::any_of(chosen.begin(), chosen.end(), [&](const cv::Point& other) {
      return std::max(std::abs(corner.x - other.x), std::abs(corner.y - other.y)) <= spacing_px;
    });
    if (!crowded) chosen.push_back(corner);  // equals, as on a drawn chart, are highest side by side
  }
  return chosen;
}

}  // namespace svchain::registration
