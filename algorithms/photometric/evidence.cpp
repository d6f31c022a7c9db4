#include "algorithms/photometric/evidence.h"

#include <algorithm>
#include <cmath>

namespace svchain::photometric {
namespace {

using synthesis::BlockSamples;
using synthesis::kChannels;

constexpr uint32_t kFewestPixels = 50;
constexpr double kFullWeightPixels = 800;
constexpr double kDarkestMean = 6;  // grey levels: below, rounding and the black level rule
constexpr double kClippedLevel = 254.5;
constexpr double kLeastClippedMean = 40;  // in darker blocks, clipped samples are black ones
constexpr double kLargestRatio = 6;
constexpr size_t kFewestUnclipped = 10;  // blocks of a camera that is not just white

// What two cameras' views of the same ground differ by (standard deviations).
constexpr double kLevelSigma = 2;         // grey levels: rounding, noise
constexpr double kRelativeSigma = 0.03;   // gloss and the like
constexpr double kSpreadSigma = 0.1;      // of the block's spread: registration
constexpr double kUnlikeSigma = 0.3;      // of the difference of both spreads
constexpr double kSaturationSigma = 0.1;  // of the clipped share

struct Moments {
  double mean = 0;
  double deviation = 0;
  double clipped = 0;  // share
};

Moments moments(const BlockSamples& samples, int channel, double pixels) {
  Moments m;
  m.mean = samples.sum[channel] / pixels;
  m.deviation = std::sqrt(std::max(0.0, samples.sum_of_squares[channel] / pixels - m.mean * m.mean));
  if (m.mean >= kLeastClippedMean) m.clipped = samples.clipped[channel] / pixels;
  return m;
}

void add_part(Brightness& brightness, double share, double level) {
  brightness.parts[brightness.count++] = {share, std::log(level)};
}

/// False where what is left beside the clipped pixels is too dark.
bool split(const Moments& all, Brightness& brightness) {
  brightness.count = 0;
  const double rest = 1 - all.clipped;
  if (rest < 0.02) {
    add_part(brightness, 1, kClippedLevel);
    return true;
  }
  const double squares = all.mean * all.mean + all.deviation * all.deviation;
  const double mean = (all.mean - all.clipped * kClippedLevel) / rest;
  if (mean < kDarkestMean) return false;
  const double variance = (squares - all.clipped * kClippedLevel * kClippedLevel) / rest - mean * mean;
  const double deviation =
      std::clamp(std::sqrt(std::max(0.0, variance)), 0.0, std::min(0.8 * mean, 255 - mean));
  if (all.clipped > 0) add_part(brightness, all.clipped, kClippedLevel);
  add_part(brightness, rest / 2, mean - deviation);
  add_part(brightness, rest / 2, mean + deviation);
  return true;
}

double sigma_of(const Moments& a, const Moments& b) {
  const double mean = std::sqrt(a.mean * b.mean);
  const double spread_a = a.deviation / a.mean, spread_b = b.deviation / b.mean;
  const double clipped = std::max(a.clipped, b.clipped);
  const auto squared = [](double x) { return x * x; };
  return std::sqrt(squared(kLevelSigma / mean) + squared(kRelativeSigma) +
                   squared(kSpreadSigma * std::max(spread_a, spread_b)) +
                   squared(kUnlikeSigma * (spread_a - spread_b)) * (1 - clipped) +
                   squared(kSaturationSigma * clipped));
}

}  // namespace

double Brightness::log_mean(const ToneCurves::Knots& knots, double log_factor,
                            Derivatives* derivatives) const {
  static const double kBrightest = std::log(255);
  if (derivatives) *derivatives = {};
  double mean = 0;
  for (int i = 0; i < count; ++i) {
    const double log_level = std::min(kBrightest, parts[i].log_level + log_factor);
    const KnotPlace place = place_of(log_level);
    const double level = parts[i].share * std::exp(log_level + log_gain_at(knots, place));
    mean += level;
    if (!derivatives) continue;
    derivatives->by_knots[place.knot] += level * (1 - place.t);
    derivatives->by_knots[place.knot + 1] += level * place.t;
    if (log_level < kBrightest) derivatives->by_log_factor += level * (1 + slope_at(knots, place));
  }
  if (derivatives) {
    for (double& derivative : derivatives->by_knots) derivative /= mean;
    derivatives->by_log_factor /= mean;
  }
  return std::log(mean);
}

double SharedBlock::log_level(const ToneCurves& curves, size_t side, size_t channel) const {
  const auto& [p1, p2] = curves.log_falloff[cameras[side]];
  return brightness[side][channel].log_mean(curves.log_gain[cameras[side]][channel],
                                            (p1 + p2 * q2[side]) * q2[side]);
}

Evidence::Evidence(size_t most_blocks) {
  blocks_.reserve(most_blocks);
}

void Evidence::take(const synthesis::OverlapStatistics& statistics, size_t cameras) {
  blocks_.clear();
  rejections_ = {};
  for (const synthesis::OverlapBlock& block : statistics.blocks()) {
    if (block.camera_a >= cameras || block.camera_b >= cameras || block.camera_a == block.camera_b) continue;
    if (blocks_.size() < blocks_.capacity()) add(block);
  }
  leave_out_white_cameras();
  shown_ = {};
  for (const SharedBlock& block : blocks_)
    for (const uint16_t camera : block.cameras) shown_[camera] = true;
}

void Evidence::add(const synthesis::OverlapBlock& block) {
  if (block.pixels < kFewestPixels) return void(++rejections_.small);
  SharedBlock shared;
  shared.cameras = {block.camera_a, block.camera_b};
  shared.q2 = {block.q2_a, block.q2_b};
  shared.weight = std::min(1.0, block.pixels / kFullWeightPixels);
  for (int c = 0; c < kChannels; ++c) {
    const Moments a = moments(block.a, c, block.pixels), b = moments(block.b, c, block.pixels);
    if (std::min(a.mean, b.mean) < kDarkestMean || !split(a, shared.brightness[0][c]) ||
        !split(b, shared.brightness[1][c]))
      return void(++rejections_.dark);
    if (std::max(a.mean, b.mean) > kLargestRatio * std::min(a.mean, b.mean))
      return void(++rejections_.contradicting);
    shared.sigma[c] = sigma_of(a, b);
    shared.clipped = std::max({shared.clipped, a.clipped, b.clipped});
  }
  blocks_.push_back(shared);
}

/// What is white everywhere tells where its curve ends and nothing else.
void Evidence::leave_out_white_cameras() {
  std::array<size_t, synthesis::kMaxCameras> unclipped = {}, all = {};
  for (const SharedBlock& block : blocks_)
    for (const uint16_t camera : block.cameras) {
      ++all[camera];
      unclipped[camera] += !block.is_clipped();
    }
  const auto is_white = [&](uint16_t camera) {
    return unclipped[camera] < std::min(kFewestUnclipped, (all[camera] + 1) / 2);
  };
  const auto of_white_camera = [&](const SharedBlock& block) {
    return block.is_clipped() && (is_white(block.cameras[0]) || is_white(block.cameras[1]));
  };
  const auto end = std::remove_if(blocks_.begin(), blocks_.end(), of_white_camera);
  rejections_.saturated += static_cast<size_t>(blocks_.end() - end);
  blocks_.resize(static_cast<size_t>(end - blocks_.begin()));
}

}  // namespace svchain::photometric
