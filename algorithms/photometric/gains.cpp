#include "algorithms/photometric/gains.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/photometric/histogram_median.h"

namespace svchain::photometric {
namespace {

using synthesis::BlockSamples;
using synthesis::kChannels;
using synthesis::kMaxCameras;
using synthesis::OverlapBlock;

constexpr uint32_t kFewestPixels = 50;
constexpr double kLargestClippedShare = 0.05;
constexpr double kDarkestMean = 6;  // grey levels: below, rounding and black level rule
const double kLargestLogRatio = std::log(4.0);
/// An outlier is further from the median than this many standard deviations (from the median deviation) ...
constexpr double kOutlierSigmas = 3;
/// ... but blocks that agree to a few percent are never outliers, however well the others agree.
constexpr double kLeastTolerance = 0.03;
/// Pull towards the last gains, relative to all overlaps together: holds the common level and moves nothing
/// else.
constexpr double kPriorWeight = 1e-7;

using PerChannel = std::array<double, kChannels>;
using LogGains = std::array<PerChannel, kMaxCameras>;

/// ln(m_a / m_b) per channel, nothing where the block tells nothing.
std::optional<PerChannel> log_ratio(const OverlapBlock& block, size_t cameras) {
  if (block.camera_a >= cameras || block.camera_b >= cameras || block.camera_a == block.camera_b) return {};
  if (block.pixels < kFewestPixels) return {};
  PerChannel ratio;
  for (int c = 0; c < kChannels; ++c) {
    for (const BlockSamples* samples : {&block.a, &block.b})
      if (samples->clipped[c] > kLargestClippedShare * block.pixels ||
          samples->sum[c] < kDarkestMean * block.pixels)
        return {};
    ratio[c] = std::log(double(block.a.sum[c]) / block.b.sum[c]);
    if (std::abs(ratio[c]) > kLargestLogRatio) return {};
  }
  return ratio;
}

/// Where ratios lie, and how far off one may be, per channel.
struct Range {
  PerChannel centre = {};
  PerChannel tolerance = {};

  bool contains(const PerChannel& value) const {
    for (int c = 0; c < kChannels; ++c)
      if (std::abs(value[c] - centre[c]) > tolerance[c]) return false;
    return true;
  }
};

/// Calls `visit_all(f)` with an f that takes a value at a time, and returns the values' median.
template <class VisitAll>
double median(double from, double to, VisitAll visit_all) {
  HistogramMedian values(from, to);
  visit_all([&](double v) { values.add(v); });
  return values.median();
}

/// How far values may lie from `centre`, by their median deviation from it.
template <class VisitAll>
double tolerance(double centre, VisitAll visit_all) {
  const double deviation = median(0, 4 * kLargestLogRatio, [&](auto visit) {
    visit_all([&](double v) { visit(std::abs(v - centre)); });
  });
  return std::max(kLeastTolerance, kOutlierSigmas * 1.4826 * deviation);
}

/// The estimate of one frame. What is rejected is decided anew whenever a block is looked at, so nothing is
/// stored per block.
class Estimation {
 public:
  Estimation(const synthesis::OverlapStatistics& statistics, size_t cameras, const LogGains& last)
      : statistics_(statistics),
        cameras_(std::min<size_t>(cameras, kMaxCameras)),
        last_(last),
        solution_(last) {}

  void run() {
    for (size_t pair = 0; pair < kMaxCameras * kMaxCameras; ++pair) find_pair_range(pair);
    solve();
    find_residual_range();
    solve();
  }

  LogGains log_gains() const { return solution_; }
  size_t used() const { return used_; }

 private:
  static size_t pair_of(const OverlapBlock& block) { return block.camera_a * kMaxCameras + block.camera_b; }

  PerChannel residual(const OverlapBlock& block, const PerChannel& ratio) const {
    PerChannel r;
    for (int c = 0; c < kChannels; ++c)
      r[c] = ratio[c] + solution_[block.camera_a][c] - solution_[block.camera_b][c];
    return r;
  }

  /// Calls f(block, ratio) for every block that no test so far has rejected.
  template <class F>
  void for_each_usable(F f) const {
    for (const OverlapBlock& block : statistics_.blocks()) {
      const auto ratio = log_ratio(block, cameras_);
      if (!ratio) continue;
      const auto& range = pair_ranges_[pair_of(block)];
      if (range && !range->contains(*ratio)) continue;
      if (residual_range_ && !residual_range_->contains(residual(block, *ratio))) continue;
      f(block, *ratio);
    }
  }

  void find_pair_range(size_t pair) {
    const bool present = std::any_of(statistics_.blocks().begin(), statistics_.blocks().end(),
                                     [&](const OverlapBlock& block) { return pair_of(block) == pair; });
    if (!present) return;
    Range range;
    for (int c = 0; c < kChannels; ++c) {
      const auto ratios = [&](auto visit) {
        for_each_usable([&](const OverlapBlock& block, const PerChannel& ratio) {
          if (pair_of(block) == pair) visit(ratio[c]);
        });
      };
      range.centre[c] = median(-kLargestLogRatio, kLargestLogRatio, ratios);
      range.tolerance[c] = tolerance(range.centre[c], ratios);
    }
    pair_ranges_[pair] = range;
  }

  void find_residual_range() {
    Range range;  // around 0, the solution
    for (int c = 0; c < kChannels; ++c)
      range.tolerance[c] = tolerance(0, [&](auto visit) {
        for_each_usable(
            [&](const OverlapBlock& block, const PerChannel& ratio) { visit(residual(block, ratio)[c]); });
      });
    residual_range_ = range;
  }

  /// The normal equations of x = ln g: a weighted graph of cameras, with the pull towards the last gains.
  void solve() {
    using Matrix = Eigen::Matrix<double, kMaxCameras, kMaxCameras>;
    using Vector = Eigen::Matrix<double, kMaxCameras, 1>;
    LogGains next;
    for (int c = 0; c < kChannels; ++c) {
      Matrix normal = Matrix::Zero();
      Vector right = Vector::Zero();
      used_ = 0;
      for_each_usable([&](const OverlapBlock& block, const PerChannel& ratio) {
        const int a = block.camera_a, b = block.camera_b;
        const double weight = double(block.a.sum[c]) * block.b.sum[c] / block.pixels;
        // In terms of x - last, of which the prior wants 0.
        const double wanted = -ratio[c] - last_[a][c] + last_[b][c];
        normal(a, a) += weight;
        normal(b, b) += weight;
        normal(a, b) -= weight;
        normal(b, a) -= weight;
        right(a) += weight * wanted;
        right(b) -= weight * wanted;
        ++used_;
      });
      if (used_ == 0) return;
      normal += kPriorWeight * normal.trace() * Matrix::Identity();
      const Vector step = normal.ldlt().solve(right);
      for (int i = 0; i < kMaxCameras; ++i) next[i][c] = last_[i][c] + step(i);
    }
    solution_ = next;
  }

  const synthesis::OverlapStatistics& statistics_;
  const size_t cameras_;
  const LogGains& last_;
  LogGains solution_;
  std::array<std::optional<Range>, kMaxCameras * kMaxCameras> pair_ranges_;
  std::optional<Range> residual_range_;
  size_t used_ = 0;
};

}  // namespace

Gains Gains::identity() {
  Gains gains;
  for (auto& camera : gains.value) camera.fill(1);
  return gains;
}

Gains estimate_gains(const synthesis::OverlapStatistics& statistics, size_t cameras, const Gains& last) {
  LogGains last_log;
  for (int i = 0; i < kMaxCameras; ++i)
    for (int c = 0; c < kChannels; ++c) last_log[i][c] = std::log(last.value[i][c]);

  Estimation estimation(statistics, cameras, last_log);
  estimation.run();
  Gains gains;
  const LogGains log_gains = estimation.log_gains();
  for (int i = 0; i < kMaxCameras; ++i)
    for (int c = 0; c < kChannels; ++c) gains.value[i][c] = std::exp(log_gains[i][c]);
  gains.blocks_used = estimation.used();
  gains.blocks_rejected = statistics.count - estimation.used();
  return gains;
}

synthesis::ToneMapping tone_mapping(const Gains& gains) {
  synthesis::ToneMapping mapping{};
  for (int i = 0; i < kMaxCameras; ++i)
    for (int c = 0; c < kChannels; ++c)
      for (int v = 0; v < 256; ++v)
        mapping.curves[i][c][v] = static_cast<uint8_t>(std::min(255.0, std::round(v * gains.value[i][c])));
  return mapping;
}

}  // namespace svchain::photometric
