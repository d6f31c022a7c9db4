#include "algorithms/calibration/grey_pictures.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace svchain::calibration {

namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

cv::Mat grey_of(const geometry::Camera& camera, const cv::Mat& picture) {
  const Eigen::Vector2i& size = camera.image_size_px;
  if (picture.cols != size.x() || picture.rows != size.y() || picture.depth() != CV_8U)
    throw std::invalid_argument("the picture of " + camera.name + ": expected " +
                                size_text(size.x(), size.y()) + " of 8 bits, as the rig has it, got " +
                                size_text(picture.cols, picture.rows));
  if (picture.channels() == 1) return picture;
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace

std::vector<cv::Mat> grey_pictures(const CalibrationInput& input) {
  const auto& cameras = input.nominal.cameras;
  if (input.pictures.empty() && !input.clicked.empty()) return std::vector<cv::Mat>(cameras.size());
  if (input.pictures.size() != cameras.size())
    throw std::invalid_argument("expected " + std::to_string(cameras.size()) + " pictures, got " +
                                std::to_string(input.pictures.size()));
  std::vector<cv::Mat> greys;
  for (size_t c = 0; c < cameras.size(); ++c) greys.push_back(grey_of(cameras[c], input.pictures[c]));
  return greys;
}

}  // namespace svchain::calibration
