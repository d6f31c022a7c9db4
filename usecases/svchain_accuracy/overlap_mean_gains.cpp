#include "usecases/svchain_accuracy/overlap_mean_gains.h"

#include <algorithm>
#include <cmath>

namespace svchain::accuracy {

using synthesis::ToneMapping;

namespace {

constexpr size_t kCameras = 4;

/// ln of the gains of one channel: the ratios' product around the vehicle should be 1, and what it is off by
/// is shared among the four overlaps.
std::array<double, kCameras> log_gains(std::span<const synthesis::OverlapBlock> blocks, int channel) {
  std::array<double, kCameras> sum_a = {}, sum_b = {}, log_ratio;
  for (const auto& block : blocks) {
    sum_a[block.camera_a] += block.a.sum[channel];
    sum_b[block.camera_a] += block.b.sum[channel];
  }
  double around = 0;
  for (size_t i = 0; i < kCameras; ++i) around += log_ratio[i] = std::log(sum_a[i] / sum_b[i]);
  std::array<double, kCameras> gains = {};
  double mean = 0;
  for (size_t i = 1; i < kCameras; ++i) {
    gains[i] = gains[i - 1] + log_ratio[i - 1] - around / kCameras;
    mean += gains[i] / kCameras;
  }
  for (double& gain : gains) gain -= mean;
  return gains;
}

void scale(ToneMapping::Curve& curve, double factor) {
  for (uint8_t& value : curve) value = static_cast<uint8_t>(std::lround(std::min(255.0, value * factor)));
}

}  // namespace

ToneMapping overlap_mean_gains(std::span<const synthesis::OverlapBlock> blocks) {
  ToneMapping mapping = ToneMapping::identity();
  for (int c = 0; c < synthesis::kChannels; ++c) {
    const auto gains = log_gains(blocks, c);
    for (size_t i = 0; i < kCameras; ++i) scale(mapping.curves[i][c], std::exp(gains[i]));
  }
  return mapping;
}

ToneMapping grey_world(const ToneMapping& gains, const cv::Scalar& means) {
  ToneMapping mapping = gains;
  const double grey = (means[0] + means[1] + means[2]) / 3;
  for (size_t i = 0; i < kCameras; ++i)
    for (int c = 0; c < synthesis::kChannels; ++c) scale(mapping.curves[i][c], grey / means[c]);
  return mapping;
}

}  // namespace svchain::accuracy
