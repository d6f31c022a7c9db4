#include "algorithms/calibration/corner_window.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace svchain::calibration {

namespace {

constexpr size_t kFewestPixels = 20;

double grey_at(const cv::Mat& grey, int x, int y) {
  return grey.depth() == CV_8U ? grey.at<uint8_t>(y, x) : double(grey.at<float>(y, x));
}

/// How the ray turns from one pixel to the next, on the plane tangent to the middle one.
std::optional<Eigen::Matrix<double, 3, 2>> across_plane(const geometry::Lens& lens,
                                                        const Eigen::Vector2d& pixel,
                                                        const Eigen::Vector3d& middle) {
  constexpr double kHalfStepPx = 0.5;
  Eigen::Matrix<double, 3, 2> across;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kHalfStepPx * Eigen::Vector2d::Unit(axis);
    const auto after = lens.unproject(pixel + step), before = lens.unproject(pixel - step);
    if (!after || !before) return std::nullopt;
    across.col(axis) = (*after / after->dot(middle) - *before / before->dot(middle)) / (2 * kHalfStepPx);
  }
  return across;
}

}  // namespace

std::optional<CornerWindow> corner_window(const cv::Mat& grey, const geometry::Lens& lens,
                                          const CornerGuess& guess, double radius_px) {
  const auto middle = lens.unproject(guess.pixel);
  if (!middle) return std::nullopt;
  const auto across = across_plane(lens, guess.pixel, *middle);
  if (!across) return std::nullopt;
  CornerWindow window{{}, *middle, *across};
  const Eigen::Matrix<double, 2, 3> place_from_plane =
      (across->transpose() * *across).inverse() * across->transpose();

  Eigen::Matrix2d edges;
  edges << guess.along_x_px, guess.along_y_px;
  const Eigen::Matrix2d shares_from_px = edges.inverse();
  const Eigen::Vector2d half =
      (kWindowShare * (guess.along_x_px.cwiseAbs() + guess.along_y_px.cwiseAbs())).cwiseMin(radius_px);
  const Eigen::Vector2d first = (guess.pixel - half).array().ceil(),
                        last = (guess.pixel + half).array().floor();
  for (int y = int(first.y()); y <= int(last.y()); ++y) {
    for (int x = int(first.x()); x <= int(last.x()); ++x) {
      const Eigen::Vector2d pixel(x, y), off = pixel - guess.pixel;
      if (!((shares_from_px * off).cwiseAbs().maxCoeff() <= kWindowShare)) continue;
      if (off.squaredNorm() > radius_px * radius_px) continue;
      if (x < 0 || y < 0 || x >= grey.cols || y >= grey.rows) return std::nullopt;
      const auto ray = lens.unproject(pixel);
      if (!ray) return std::nullopt;
      window.pixels.push_back({place_from_plane * (*ray / ray->dot(*middle) - *middle), grey_at(grey, x, y)});
    }
  }
  if (window.pixels.size() < kFewestPixels) return std::nullopt;
  return window;
}

}  // namespace svchain::calibration
