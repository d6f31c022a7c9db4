#include "algorithms/calibration/ground_picture.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;

constexpr int kLevels = 5;

double metres_per_ground_px(double side_m) {
  return side_m / kSidePx;
}

/// How far away from the camera the ground can be resolved: a square at distance d on the ground, seen from
/// height h, takes side h / (h^2 + d^2) rad along the line of sight.
double reach_m(const geometry::Camera& camera, double side_m, double least_side_px) {
  constexpr double kSmallAngleRad = 0.01;
  constexpr double kOffNominal = 1.3;
  const auto aside = camera.lens->project({std::sin(kSmallAngleRad), 0, std::cos(kSmallAngleRad)});
  const auto middle = camera.lens->project({0, 0, 1});
  if (!aside || !middle) return 0;
  const double px_per_rad = (*aside - *middle).norm() / kSmallAngleRad;
  const double height_m = std::max(camera.vehicle_from_camera.translation.z(), side_m);
  return kOffNominal * std::sqrt(side_m * height_m * px_per_rad / least_side_px);
}

geometry::View view_around(const geometry::Camera& camera, double side_m, double least_side_px) {
  constexpr double kMostPx = 1600;
  geometry::View view;
  view.metres_per_px = metres_per_ground_px(side_m);
  const double across = std::min(2 * reach_m(camera, side_m, least_side_px) / view.metres_per_px, kMostPx);
  view.size_px.setConstant(static_cast<int>(std::ceil(across)));
  view.centre_m = camera.vehicle_from_camera.translation.head<2>();
  return view;
}

/// Where every kEvery-th pixel of the view lies in the camera's picture; NaN where it does not. Between them
/// it is even enough.
constexpr int kEvery = 4;

cv::Mat2f picture_places(const geometry::Camera& camera, const geometry::View& view) {
  const geometry::Rigid3 camera_from_vehicle = camera.vehicle_from_camera.inverse();
  cv::Mat2f places(view.size_px.y() / kEvery + 2, view.size_px.x() / kEvery + 2);
  for (int j = 0; j < places.rows; ++j) {
    for (int i = 0; i < places.cols; ++i) {
      const Vector2d ground = view.ground_from_pixel({kEvery * i, kEvery * j});
      const auto pixel =
          camera.lens->project(camera_from_vehicle * Eigen::Vector3d(ground.x(), ground.y(), 0));
      places(j, i) = pixel && camera.contains(*pixel)
                         ? cv::Vec2f(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()))
                         : cv::Vec2f::all(NAN);
    }
  }
  return places;
}

/// Least and greatest number of picture pixels for one of the view, over all directions, in a cell.
Vector2d stretch(const cv::Mat2f& places, int i, int j) {
  const cv::Vec2f du =
      (places(j, i + 1) - places(j, i) + places(j + 1, i + 1) - places(j + 1, i)) / (2.F * kEvery);
  const cv::Vec2f dv =
      (places(j + 1, i) - places(j, i) + places(j + 1, i + 1) - places(j, i + 1)) / (2.F * kEvery);
  // Singular values of [a b; c d].
  const double a = du[0], b = dv[0], c = du[1], d = dv[1];
  const double sum = std::hypot(a + d, c - b), difference = std::hypot(a - d, c + b);
  return {std::abs(sum - difference) / 2, (sum + difference) / 2};
}

float bilinear(const cv::Mat1b& picture, float x, float y) {
  const int i = std::clamp(static_cast<int>(std::floor(x)), 0, picture.cols - 2);
  const int j = std::clamp(static_cast<int>(std::floor(y)), 0, picture.rows - 2);
  const float u = std::clamp(x - static_cast<float>(i), 0.F, 1.F);
  const float v = std::clamp(y - static_cast<float>(j), 0.F, 1.F);
  const uint8_t* above = picture.ptr(j) + i;
  const uint8_t* below = picture.ptr(j + 1) + i;
  const auto mix = [&](const uint8_t* row) {
    return static_cast<float>(row[0]) + u * static_cast<float>(row[1] - row[0]);
  };
  return mix(above) + v * (mix(below) - mix(above));
}

std::vector<cv::Mat1b> pyramid(const cv::Mat& grey) {
  std::vector<cv::Mat1b> levels = {grey};
  while (levels.size() < kLevels && std::min(levels.back().rows, levels.back().cols) > 32) {
    cv::Mat1b half;
    cv::pyrDown(levels.back(), half);
    levels.push_back(half);
  }
  return levels;
}

/// Fills the cell whose upper left corner is place (i, j).
void fill(const cv::Mat2f& places, int i, int j, const std::vector<cv::Mat1b>& levels, double least_side_px,
          GroundPicture& made) {
  const Vector2d px = stretch(places, i, j);
  if (!(px.minCoeff() * kSidePx >= least_side_px)) return;  // NaN too
  // The finer of the two levels about the geometric mean of both stretches.
  const double mean = std::max(std::sqrt(px.x() * px.y()), 1.0);
  const int level = std::min(static_cast<int>(std::log2(mean)), static_cast<int>(levels.size()) - 1);
  const float scale = 1.F / static_cast<float>(1 << level);
  const int rows = std::min(kEvery, made.grey.rows - kEvery * j),
            columns = std::min(kEvery, made.grey.cols - kEvery * i);
  for (int v = 0; v < rows; ++v) {
    const float down = static_cast<float>(v) / kEvery;
    const cv::Vec2f left = places(j, i) + down * (places(j + 1, i) - places(j, i));
    const cv::Vec2f right = places(j, i + 1) + down * (places(j + 1, i + 1) - places(j, i + 1));
    for (int u = 0; u < columns; ++u) {
      const cv::Vec2f place = scale * (left + static_cast<float>(u) / kEvery * (right - left));
      made.grey.at<float>(kEvery * j + v, kEvery * i + u) =
          bilinear(levels[static_cast<size_t>(level)], place[0], place[1]);
      made.seen.at<uint8_t>(kEvery * j + v, kEvery * i + u) = 255;
    }
  }
}

}  // namespace

GroundPicture ground_picture(const geometry::Camera& camera, const cv::Mat& grey, double side_m,
                             double least_side_px) {
  GroundPicture made;
  made.view = view_around(camera, side_m, least_side_px);
  const cv::Mat2f places = picture_places(camera, made.view);
  const std::vector<cv::Mat1b> levels = pyramid(grey);
  made.grey = cv::Mat1f(made.view.size_px.y(), made.view.size_px.x(), 0.F);
  made.seen = cv::Mat1b(made.grey.size(), 0);
  for (int j = 0; j + 1 < places.rows; ++j) {
    for (int i = 0; i + 1 < places.cols; ++i) fill(places, i, j, levels, least_side_px, made);
  }
  return made;
}

}  // namespace svchain::calibration
