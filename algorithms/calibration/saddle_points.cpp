#include "algorithms/calibration/saddle_points.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace svchain::calibration {

namespace {

constexpr int kRadius = 5;            // px: within the four squares, whatever their direction
constexpr double kInnerRadius = 1.2;  // px: nearer than this the direction means little
constexpr float kLeastShare = 0.45F;
constexpr float kLeastAmplitude = 6;  // grey levels

struct Kernels {
  cv::Mat1f cosine, sine, disc;
  double energy = 0;  // sum of cosine^2 + sine^2
};

Kernels make_kernels() {
  constexpr int kSize = 2 * kRadius + 1;
  Kernels k{cv::Mat1f(kSize, kSize, 0.F), cv::Mat1f(kSize, kSize, 0.F), cv::Mat1f(kSize, kSize, 0.F)};
  double count = 0;
  for (int v = -kRadius; v <= kRadius; ++v) {
    for (int u = -kRadius; u <= kRadius; ++u) {
      const double r = std::hypot(u, v);
      if (r > kRadius + 0.3 || r < kInnerRadius) continue;
      const double angle = std::atan2(v, u);
      k.cosine(v + kRadius, u + kRadius) = static_cast<float>(std::cos(2 * angle));
      k.sine(v + kRadius, u + kRadius) = static_cast<float>(std::sin(2 * angle));
      k.disc(v + kRadius, u + kRadius) = 1;
      ++count;
    }
  }
  k.disc /= count;
  k.energy = count;
  return k;
}

/// Place of a peak between pixels, by the parabolas through it and its neighbours.
Eigen::Vector2d peak(const cv::Mat1f& response, int i, int j) {
  const auto offset = [](double before, double at, double after) {
    const double curvature = before - 2 * at + after;
    return curvature < 0 ? std::clamp((before - after) / (2 * curvature), -0.5, 0.5) : 0.0;
  };
  return {i + offset(response(j, i - 1), response(j, i), response(j, i + 1)),
          j + offset(response(j - 1, i), response(j, i), response(j + 1, i))};
}

/// Direction in the vehicle's frame of a direction (u, v) in the picture: forward is up, left is left.
double vehicle_angle(double picture_angle) {
  return std::atan2(-std::cos(picture_angle), -std::sin(picture_angle));
}

}  // namespace

std::vector<SaddlePoint> find_saddles(const GroundPicture& picture) {
  const Kernels kernels = make_kernels();
  cv::Mat1f cosine, sine, mean, mean_square;
  cv::filter2D(picture.grey, cosine, CV_32F, kernels.cosine);
  cv::filter2D(picture.grey, sine, CV_32F, kernels.sine);
  cv::filter2D(picture.grey, mean, CV_32F, kernels.disc);
  cv::filter2D(picture.grey.mul(picture.grey), mean_square, CV_32F, kernels.disc);
  cv::Mat seen;
  cv::erode(picture.seen, seen, cv::Mat(), {-1, -1}, kRadius, cv::BORDER_CONSTANT, 0);

  // With N pixels: harmonic amplitude 2 |C| / N, its share of the variance 2 |C|^2 / (N^2 var).
  const auto n = static_cast<float>(kernels.energy);
  cv::Mat1f response(cosine.size(), 0.F);
  for (int j = 0; j < response.rows; ++j) {
    for (int i = 0; i < response.cols; ++i) {
      if (!seen.at<uint8_t>(j, i)) continue;
      const float variance = std::max(mean_square(j, i) - mean(j, i) * mean(j, i), 1.F);
      const float power = cosine(j, i) * cosine(j, i) + sine(j, i) * sine(j, i);
      const float share = 2 * power / (n * n * variance);
      if (share >= kLeastShare && 2 * std::sqrt(power) / n >= kLeastAmplitude) response(j, i) = share;
    }
  }
  cv::Mat1f strongest;
  cv::dilate(response, strongest, cv::Mat(), {-1, -1}, 2);
  std::vector<SaddlePoint> found;
  for (int j = 1; j + 1 < response.rows; ++j) {
    for (int i = 1; i + 1 < response.cols; ++i) {
      if (response(j, i) == 0 || response(j, i) < strongest(j, i)) continue;
      const double light_axis = std::atan2(sine(j, i), cosine(j, i)) / 2;
      found.push_back({picture.view.ground_from_pixel(peak(response, i, j)),
                       vehicle_angle(light_axis + CV_PI / 2), response(j, i)});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.strength > b.strength; });
  return found;
}

}  // namespace svchain::calibration
