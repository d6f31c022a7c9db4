#include "algorithms/photometric/starting_shift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace svchain::photometric {
namespace {

using synthesis::kMaxCameras;

constexpr int kRounds = 10;
constexpr double kLeastDifference = 0.005;  // below, absolute values are taken for squares
constexpr double kFullWeightBlocks = 20;
/// Weight of a camera's own change beside a pair's difference: only breaks ties.
constexpr double kSparsity = 1e-3;

struct PairMedian {
  size_t a = 0, b = 0;
  double median = 0;  // of ln(a / b)
  double weight = 0;
};

struct PairMedians {
  std::array<PairMedian, kMaxCameras * kMaxCameras> pairs;
  size_t count = 0;
};

PairMedians pair_medians(const Evidence& evidence, const ToneCurves& curves, size_t cameras, size_t channel,
                         std::vector<double>& scratch) {
  PairMedians medians;
  for (size_t a = 0; a < cameras; ++a)
    for (size_t b = 0; b < cameras; ++b) {
      scratch.clear();
      for (const SharedBlock& block : evidence.blocks())
        if (block.cameras[0] == a && block.cameras[1] == b && !block.is_clipped())
          scratch.push_back(block.log_ratio(curves, channel));
      if (scratch.empty()) continue;
      const auto middle = scratch.begin() + static_cast<ptrdiff_t>(scratch.size() / 2);
      std::nth_element(scratch.begin(), middle, scratch.end());
      const double weight = std::min(1.0, static_cast<double>(scratch.size()) / kFullWeightBlocks);
      medians.pairs[medians.count++] = {a, b, *middle, weight};
    }
  return medians;
}

/// Least absolute values by iteratively reweighted least squares.
Eigen::Matrix<double, kMaxCameras, 1> least_absolute(const PairMedians& medians) {
  using Matrix = Eigen::Matrix<double, kMaxCameras, kMaxCameras>;
  using Vector = Eigen::Matrix<double, kMaxCameras, 1>;
  Vector shift = Vector::Zero();
  for (int round = 0; round < kRounds; ++round) {
    const auto weight = [&](double difference) {
      return round == 0 ? 1 : 1 / std::max(kLeastDifference, std::abs(difference));
    };
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    for (size_t i = 0; i < medians.count; ++i) {
      const auto& [a, b, median, pair_weight] = medians.pairs[i];
      const double w = pair_weight * weight(median + shift[a] - shift[b]);
      normal(a, a) += w;
      normal(b, b) += w;
      normal(a, b) -= w;
      normal(b, a) -= w;
      right[a] -= w * median;
      right[b] += w * median;
    }
    for (int i = 0; i < kMaxCameras; ++i) normal(i, i) += kSparsity * weight(shift[i]);
    shift = normal.ldlt().solve(right);
  }
  return shift;
}

}  // namespace

Shifts starting_shifts(const Evidence& evidence, const ToneCurves& curves, size_t cameras,
                       std::vector<double>& scratch) {
  Shifts shifts = {};
  for (size_t c = 0; c < synthesis::kChannels; ++c) {
    const auto shift = least_absolute(pair_medians(evidence, curves, cameras, c, scratch));
    for (size_t i = 0; i < cameras; ++i) shifts[i][c] = shift[static_cast<int>(i)];
  }
  return shifts;
}

}  // namespace svchain::photometric
