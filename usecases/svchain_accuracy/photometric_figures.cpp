#include "usecases/svchain_accuracy/photometric_figures.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "algorithms/photometric/block_means.h"
#include "algorithms/photometric/photometric_alignment.h"
#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/synthesize.h"
#include "usecases/svchain_accuracy/overlap_mean_gains.h"

namespace svchain::accuracy {

namespace {

using synthesis::OverlapStatistics;
using synthesis::ToneMapping;

constexpr int kFewestPixels = 50;  // of a block that is measured
constexpr int kSquarePx = 21;  // whose means are compared with the ideal view: finer grain no camera resolves

double mean_of(const cv::Scalar& bgr) {
  return (bgr[0] + bgr[1] + bgr[2]) / 3;
}

/// (1 + f1 q^2 + f2 q^4)^gamma as a polynomial of the same form, by least squares up to q^2 = 1.2.
std::array<int32_t, 2> inverse_falloff(const scene::Response& response) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (double q2 = 0.05; q2 < 1.225; q2 += 0.05) {
    const Eigen::Vector2d row(q2, q2 * q2);
    const double factor = 1 + response.falloff[0] * q2 + response.falloff[1] * q2 * q2;
    normal += row * row.transpose();
    right += row * (std::pow(factor, response.gamma) - 1);
  }
  const Eigen::Vector2d a = normal.inverse() * right * synthesis::kRadialOne;
  return {static_cast<int32_t>(std::lround(a[0])), static_cast<int32_t>(std::lround(a[1]))};
}

ToneMapping::Curve inverse_curve(const scene::Response& response, size_t channel) {
  ToneMapping::Curve curve;
  for (int v = 0; v < 256; ++v) {
    const double light = 255 * std::pow(v / 255.0, 1 / response.gamma) / response.gain_bgr[channel];
    curve[v] = static_cast<uint8_t>(std::lround(std::min(255.0, light)));
  }
  return curve;
}

ToneMapping ours(const OverlapStatistics& statistics, bool falloff) {
  photometric::PhotometricAlignment alignment({.most_blocks = statistics.capacity, .falloff = falloff});
  return alignment.update(statistics);
}

}  // namespace

PhotometricMeasurement::PhotometricMeasurement(const PhotometricSet& set) : set_(set) {
  lut_memory_.resize(synthesis::geometric_lut_capacity(set.view, set.rig.cameras.size()));
  synthesis::build_geometric_lut(set.rig, set.view, {}, lut_memory_);
  lut_.emplace(lut_memory_);
  statistics_memory_.resize(OverlapStatistics::bytes_for(set.view));
  statistics_ = OverlapStatistics::create(statistics_memory_);
  before_.create(set.view.size_px.y(), set.view.size_px.x(), CV_8UC3);
  synthesis::synthesize(*lut_, set.frames, ToneMapping::identity(), before_, statistics_);

  ToneMapping constant = ToneMapping::identity();
  cv::Mat differing[2];
  for (const int value : {0, 255}) {
    for (auto& camera : constant.curves)
      for (auto& curve : camera) curve.fill(static_cast<uint8_t>(value));
    differing[value / 255] = composite(constant);
  }
  cv::Mat apart = differing[0] != differing[1];
  cv::extractChannel(apart, shown_, 0);
}

cv::Mat PhotometricMeasurement::composite(const ToneMapping& mapping, synthesis::Kernel kernel) const {
  cv::Mat out(before_.size(), CV_8UC3);
  synthesis::synthesize(*lut_, set_.frames, mapping, out, nullptr, kernel);
  return out;
}

int PhotometricMeasurement::parity_of(uint32_t block) const {
  const auto& place = lut_->blocks()[block];
  return (place.x / synthesis::kBlockSize + place.y / synthesis::kBlockSize) % 2;
}

PhotometricMeasurement::Half PhotometricMeasurement::half(int parity) const {
  Half half{std::vector<std::byte>(statistics_memory_.size()), nullptr};
  half.statistics = OverlapStatistics::create(half.memory);
  for (const auto& block : statistics_->blocks())
    if (parity_of(block.block) == parity) half.statistics->add(block);
  return half;
}

cv::Scalar PhotometricMeasurement::composite_mean(const cv::Mat& composite) const {
  return cv::mean(composite, shown_);
}

double PhotometricMeasurement::composite_contrast(const cv::Mat& composite) const {
  cv::Scalar mean, deviation;
  cv::meanStdDev(composite, mean, deviation, shown_);
  return mean_of(deviation) / mean_of(mean);
}

/// Means over squares of kSquarePx about every pixel that shows a camera, of such pixels alone.
cv::Mat PhotometricMeasurement::local_means(const cv::Mat& picture) const {
  cv::Mat counted = cv::Mat::zeros(picture.size(), CV_8UC3), sums, weights;
  picture.copyTo(counted, shown_);
  const cv::Size square(kSquarePx, kSquarePx);
  cv::boxFilter(counted, sums, CV_32F, square, {-1, -1}, false);
  cv::boxFilter(shown_ / 255, weights, CV_32F, square, {-1, -1}, false);
  cv::Mat three, means;
  cv::merge(std::vector<cv::Mat>(3, weights), three);
  cv::divide(sums, cv::max(three, 1), means);
  means.convertTo(means, CV_8UC3);
  return means;
}

/// The common curve gives every value of a channel the mean of what the ideal view has there.
double PhotometricMeasurement::distance_from_ideal(const cv::Mat& composite) const {
  double distance = 0;
  const cv::Mat made = local_means(composite), wanted = local_means(set_.truth->ideal);
  const auto for_each = [&](auto visit) {
    for (int row = 0; row < made.rows; ++row)
      for (int column = 0; column < made.cols; ++column)
        if (shown_.at<uint8_t>(row, column))
          visit(made.at<cv::Vec3b>(row, column), wanted.at<cv::Vec3b>(row, column));
  };
  for (int c = 0; c < 3; ++c) {
    std::array<double, 256> sum = {}, count = {};
    for_each([&](const cv::Vec3b& ours, const cv::Vec3b& ideal) {
      sum[ours[c]] += ideal[c];
      ++count[ours[c]];
    });
    for_each([&](const cv::Vec3b& ours, const cv::Vec3b& ideal) {
      distance += std::abs(ideal[c] - sum[ours[c]] / count[ours[c]]);
    });
  }
  return distance / 3 / cv::countNonZero(shown_);
}

ToneMapping PhotometricMeasurement::baseline(const OverlapStatistics& statistics) const {
  const ToneMapping gains = overlap_mean_gains(statistics.blocks());
  return grey_world(gains, composite_mean(composite(gains)));
}

ToneMapping PhotometricMeasurement::inverse_responses(bool with_falloff) const {
  ToneMapping mapping = ToneMapping::identity();
  for (size_t i = 0; i < 4; ++i) {
    const scene::Response& response = set_.truth->responses[i];
    for (size_t c = 0; c < 3; ++c) mapping.curves[i][c] = inverse_curve(response, c);
    if (with_falloff) mapping.falloff[i] = inverse_falloff(response);
  }
  return mapping;
}

PhotometricFigures PhotometricMeasurement::measure(const std::string& name, const Method& method) const {
  PhotometricFigures figures;
  figures.method = name;
  std::array<int, 4> counts = {};
  for (const int parity : {0, 1}) {
    const ToneMapping mapping = method(*half(parity).statistics);
    const cv::Mat corrected = composite(mapping);
    const double equal_mean = mean_of(composite_mean(before_)) / mean_of(composite_mean(corrected));
    for (const auto& block : photometric::block_means(*lut_, set_.frames, mapping)) {
      if (block.pixels < kFewestPixels || parity_of(block.block) == parity) continue;
      const auto overlap = static_cast<size_t>(block.camera_a);
      figures.overlaps[overlap] += equal_mean * block.difference();
      ++counts[overlap];
    }
    if (parity == 1) continue;
    figures.contrast = composite_contrast(corrected) / composite_contrast(before_);
    if (set_.truth) figures.from_ideal = distance_from_ideal(corrected);
  }
  double all = 0;
  for (size_t i = 0; i < 4; ++i) {
    figures.left += figures.overlaps[i];
    all += counts[i];
    figures.overlaps[i] /= counts[i];
  }
  figures.left /= all;
  return figures;
}

std::vector<PhotometricFigures> PhotometricMeasurement::measure_all() const {
  std::vector<PhotometricFigures> all;
  all.push_back(measure("before", [](auto&) { return ToneMapping::identity(); }));
  all.push_back(measure("baseline", [&](auto& s) { return baseline(s); }));
  if (set_.truth) {
    all.push_back(measure("true responses inverted", [&](auto&) { return inverse_responses(false); }));
    all.push_back(measure("and falloff", [&](auto&) { return inverse_responses(true); }));
  }
  all.push_back(measure("ours, without falloff", [](auto& s) { return ours(s, false); }));
  all.push_back(measure("ours", [](auto& s) { return ours(s, true); }));
  return all;
}

}  // namespace svchain::accuracy
