#include "algorithms/registration/harris.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace svchain::registration {

namespace {

constexpr int kWindowPx = 9;
constexpr int kDerivativePx = 5;
constexpr double kHarris = 0.06;

}  // namespace

std::vector<cv::Point> strongest_corners(const cv::Mat& picture, const cv::Mat& where, size_t most,
                                         int spacing_px) {
  cv::Mat response, highest;
  cv::cornerHarris(picture, response, kWindowPx, kDerivativePx, kHarris);
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
  if (corners.size() > most) corners.resize(most);
  return corners;
}

}  // namespace svchain::registration
