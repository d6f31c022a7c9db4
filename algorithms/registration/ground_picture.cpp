#include "algorithms/registration/ground_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace svchain::registration {

namespace {

constexpr int kLevels = 5;
constexpr int kBlock = 4;  // pixels between places that are projected through the lens; linear in between
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

/// Pixels of the image at every kBlock-th pixel of the view, one more than fit.
cv::Mat projected(const GroundCamera& camera, const geometry::View& view) {
  cv::Mat nodes(view.size_px.y() / kBlock + 2, view.size_px.x() / kBlock + 2, CV_32FC2);
  for (int j = 0; j < nodes.rows; ++j) {
    auto* row = nodes.ptr<cv::Vec2f>(j);
    for (int i = 0; i < nodes.cols; ++i) {
      const auto pixel = camera.project(view.ground_from_pixel(Eigen::Vector2d(i * kBlock, j * kBlock)));
      row[i] = pixel ? cv::Vec2f(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()))
                     : cv::Vec2f(kNowhere, kNowhere);
    }
  }
  return nodes;
}

float sample(const cv::Mat& picture, float x, float y) {
  if (!(x >= 0 && y >= 0 && x <= static_cast<float>(picture.cols - 1) &&
        y <= static_cast<float>(picture.rows - 1))) {
    return 0;  // also where x or y is not a number
  }
  const int i = std::min(static_cast<int>(x), picture.cols - 2);
  const int j = std::min(static_cast<int>(y), picture.rows - 2);
  const float s = x - static_cast<float>(i);
  const float t = y - static_cast<float>(j);
  const auto* upper = picture.ptr<float>(j) + i;
  const auto* lower = picture.ptr<float>(j + 1) + i;
  return (1 - t) * ((1 - s) * upper[0] + s * upper[1]) + t * ((1 - s) * lower[0] + s * lower[1]);
}

/// The level whose pixels are about as large as the view's: 0 where these are smaller than the image's.
size_t level_for(const cv::Vec2f& across, const cv::Vec2f& down, size_t levels) {
  const float area = std::abs(across[0] * down[1] - across[1] * down[0]) / (kBlock * kBlock);
  if (!(area > 1)) return 0;
  return std::min(static_cast<size_t>(std::lround(0.5F * std::log2(area))), levels - 1);
}

}  // namespace

Pyramid pyramid(const cv::Mat& frame) {
  cv::Mat grey = frame;
  if (frame.channels() == 3) cv::cvtColor(frame, grey, cv::COLOR_BGR2GRAY);
  Pyramid levels(1);
  grey.convertTo(levels[0], CV_32F);
  while (levels.size() < kLevels && std::min(levels.back().cols, levels.back().rows) >= 16) {
    const cv::Size halved(levels.back().cols / 2, levels.back().rows / 2);
    cv::Mat half;
    cv::resize(levels.back()({0, 0, 2 * halved.width, 2 * halved.height}), half, halved, 0, 0,
               cv::INTER_AREA);
    levels.push_back(half);
  }
  return levels;
}

cv::Mat ground_picture(const Pyramid& frame, const GroundCamera& camera, const geometry::View& view) {
  const cv::Mat nodes = projected(camera, view);
  cv::Mat picture(view.size_px.y(), view.size_px.x(), CV_32F);
  for (int j = 0; j < picture.rows; ++j) {
    const auto* upper = nodes.ptr<cv::Vec2f>(j / kBlock);
    const auto* lower = nodes.ptr<cv::Vec2f>(j / kBlock + 1);
    const float t = static_cast<float>(j % kBlock) / kBlock;
    auto* row = picture.ptr<float>(j);
    for (int block = 0; block * kBlock < picture.cols; ++block) {
      const cv::Vec2f from = (1 - t) * upper[block] + t * lower[block];
      const cv::Vec2f across = (1 - t) * upper[block + 1] + t * lower[block + 1] - from;
      const size_t level = level_for(across, lower[block] - upper[block], frame.size());
      const float scale = 1 / static_cast<float>(1 << level);
      const int width = std::min(kBlock, picture.cols - block * kBlock);
      for (int i = 0; i < width; ++i) {
        const cv::Vec2f pixel = from + static_cast<float>(i) / kBlock * across;
        row[block * kBlock + i] =
            sample(frame[level], (pixel[0] + 0.5F) * scale - 0.5F, (pixel[1] + 0.5F) * scale - 0.5F);
      }
    }
  }
  return picture;
}

}  // namespace svchain::registration
