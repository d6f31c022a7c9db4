#include "algorithms/photometric/joint_fit.h"

#include <algorithm>
#include <cmath>

namespace svchain::photometric {
namespace {

using synthesis::kChannels;

// Expectations, as standard deviations: of gammas, of bends between neighbouring stretches of a curve, where
// the last stretch serves the clipped values and may be anything, and of falloffs. Clipped in all channels is
// white, and white has no colour.
constexpr double kGammaSigma = 0.12;
constexpr double kLastSlopeSigma = 3;
constexpr double kBendSigma = 0.1;
constexpr double kLastBendSigma = 0.25;
constexpr double kWhiteSigma = 0.3;
constexpr double kFalloffSigmas[2] = {0.6, 0.3};
constexpr double kLevelStiffness = 1e-4;  // keeps what nothing determines where it is

/// Neighbouring blocks err together: ten count as one.
constexpr double kIndependence = 0.1;
constexpr double kOutlierSigmas = 2.5;
constexpr double kMedianOfChi = 0.8;  // of three channels' root mean square
constexpr double kLeastScale = 0.3, kLargestScale = 3;

/// Mean square of falloffs in their own sigmas. Noise alone gives 0.0 to 0.1, a lens that loses 10 % at the
/// picture's rim 1 and more.
constexpr double kFalloffShows = 0.2, kFalloffShowsNoMore = 0.1;

constexpr double kSumStiffness = 1e7;
constexpr double kFixed = 1e8;

double square(double x) {
  return x * x;
}

double log_step(int knot) {
  return std::log(kKnotLevels[knot + 1] / kKnotLevels[knot]);
}

}  // namespace

JointFit::JointFit(size_t cameras, size_t most_blocks, bool with_falloff)
    : cameras_(cameras),
      knots_(static_cast<int>(cameras) * kChannels * kKnots),
      length_(knots_ + 2 * static_cast<int>(cameras)),
      with_falloff_(with_falloff),
      state_(Vector::Zero(length_)),
      gradient_(Vector::Zero(length_)),
      step_(Vector::Zero(length_)),
      curvature_(Matrix::Zero(length_, length_)),
      remembered_(Matrix::Zero(length_, length_)),
      system_(Matrix::Zero(length_, length_)),
      factor_(length_) {
  distances_.reserve(most_blocks);
}

int JointFit::knot_index(size_t camera, size_t channel, int knot) const {
  return static_cast<int>(channel * cameras_ + camera) * kKnots + knot;
}

int JointFit::falloff_index(size_t camera) const {
  return knots_ + 2 * static_cast<int>(camera);
}

void JointFit::step(const Evidence& evidence, double rate, ToneCurves& curves) {
  if (evidence.blocks().empty()) return;
  for (size_t i = 0; i < cameras_; ++i) {
    for (size_t c = 0; c < kChannels; ++c)
      for (int k = 0; k < kKnots; ++k) state_[knot_index(i, c, k)] = curves.log_gain[i][c][k];
    for (int n = 0; n < 2; ++n) state_[falloff_index(i) + n] = curves.log_falloff[i][n];
  }
  add_evidence(evidence, curves);
  remember(evidence, rate);
  system_ = remembered_;
  add_expectations();
  hold(evidence);
  factor_.compute(system_);
  if (factor_.info() != Eigen::Success) return;  // statistics that no frame could have given
  solve(rate);
  for (size_t i = 0; i < cameras_; ++i) {
    if (!evidence.shows(i)) continue;
    for (size_t c = 0; c < kChannels; ++c)
      for (int k = 0; k < kKnots; ++k) curves.log_gain[i][c][k] = state_[knot_index(i, c, k)];
    for (int n = 0; n < 2; ++n) curves.log_falloff[i][n] = state_[falloff_index(i) + n];
  }
}

void JointFit::add_evidence(const Evidence& evidence, const ToneCurves& curves) {
  curvature_.setZero();
  gradient_.setZero();
  distances_.clear();
  contradicting_ = 0;
  for (const SharedBlock& block : evidence.blocks()) add_block(block, curves);
  curvature_.triangularView<Eigen::StrictlyUpper>() = curvature_.transpose();

  const auto middle = distances_.begin() + static_cast<ptrdiff_t>(distances_.size() / 2);
  std::nth_element(distances_.begin(), middle, distances_.end());
  scale_ = std::clamp(*middle / kMedianOfChi, kLeastScale, kLargestScale);
}

/// The derivatives of a block's three differences, all of them first, for their weight is one.
void JointFit::add_block(const SharedBlock& block, const ToneCurves& curves) {
  std::array<Row, kChannels> rows;
  double chi = 0;
  for (size_t c = 0; c < kChannels; ++c) {
    rows[c] = row_of(block, curves, c);
    chi += square(rows[c].difference / block.sigma[c]) / kChannels;
  }
  chi = std::sqrt(chi);
  distances_.push_back(chi);
  const double belief = 1 / square(1 + square(chi / (kOutlierSigmas * scale_)));
  contradicting_ += belief < 0.25;
  for (size_t c = 0; c < kChannels; ++c) {
    const Row& row = rows[c];
    const double weight = kIndependence * block.weight * belief / square(block.sigma[c] * scale_);
    for (int i = 0; i < row.count; ++i) {
      const double weighted = weight * row.derivative[i];
      gradient_[row.index[i]] -= weighted * row.difference;
      for (int j = 0; j < row.count; ++j)
        if (row.index[j] <= row.index[i])
          curvature_(row.index[i], row.index[j]) += weighted * row.derivative[j];
    }
  }
}

JointFit::Row JointFit::row_of(const SharedBlock& block, const ToneCurves& curves, size_t channel) const {
  Row row;
  for (size_t side = 0; side < 2; ++side) {
    const size_t camera = block.cameras[side];
    const double sign = side == 0 ? 1 : -1, q2 = block.q2[side];
    const auto& [p1, p2] = curves.log_falloff[camera];
    Brightness::Derivatives derivatives;
    row.difference += sign * block.brightness[side][channel].log_mean(curves.log_gain[camera][channel],
                                                                      (p1 + p2 * q2) * q2, &derivatives);
    for (int k = 0; k < kKnots; ++k)
      if (derivatives.by_knots[k] != 0)
        row.add(knot_index(camera, channel, k), sign * derivatives.by_knots[k]);
    row.add(falloff_index(camera), sign * derivatives.by_log_factor * q2);
    row.add(falloff_index(camera) + 1, sign * derivatives.by_log_factor * q2 * q2);
  }
  return row;
}

/// A camera that is not shown keeps all that is remembered of it.
void JointFit::remember(const Evidence& evidence, double rate) {
  const auto camera_of = [&](int index) {
    return static_cast<size_t>(index < knots_ ? index / kKnots : (index - knots_) / 2) % cameras_;
  };
  for (int column = 0; column < length_; ++column) {
    if (!evidence.shows(camera_of(column))) continue;
    for (int row = 0; row < length_; ++row)
      if (evidence.shows(camera_of(row)))
        remembered_(row, column) += rate * (curvature_(row, column) - remembered_(row, column));
  }
}

/// The expectation that a sum of the state's terms is 0.
void JointFit::expect(std::initializer_list<std::pair<int, double>> terms, double sigma) {
  double value = 0;
  for (const auto& [index, factor] : terms) value += factor * state_[index];
  const double weight = 1 / square(sigma);
  for (const auto& [row, factor] : terms) {
    gradient_[row] -= weight * factor * value;
    for (const auto& [column, other] : terms) system_(row, column) += weight * factor * other;
  }
}

void JointFit::add_expectations() {
  static const double whole_range = std::log(kKnotLevels[kKnots - 1] / kKnotLevels[0]);
  for (size_t i = 0; i < cameras_; ++i) {
    for (size_t c = 0; c < kChannels; ++c) {
      const auto at = [&](int k) { return knot_index(i, c, k); };
      for (int k = 0; k + 1 < kKnots; ++k) {
        const double slope = 1 / log_step(k);
        const double sigma = k + 2 < kKnots ? kGammaSigma * std::sqrt(whole_range * slope) : kLastSlopeSigma;
        expect({{at(k), -slope}, {at(k + 1), slope}}, sigma);
      }
      for (int k = 0; k + 2 < kKnots; ++k) {
        const double before = 1 / log_step(k), after = 1 / log_step(k + 1);
        expect({{at(k), before}, {at(k + 1), -before - after}, {at(k + 2), after}},
               k + 3 < kKnots ? kBendSigma : kLastBendSigma);
      }
      expect({{at(kKnots - 1), 1}, {knot_index(i, (c + 1) % kChannels, kKnots - 1), -1}}, kWhiteSigma);
    }
    for (int n = 0; n < 2; ++n) expect({{falloff_index(i) + n, 1}}, kFalloffSigmas[n]);
  }
  for (int k = 0; k < knots_; ++k) system_(k, k) += kLevelStiffness;
}

/// Sums over the cameras stay at every knot, and cameras that are not shown stay as they are.
void JointFit::hold(const Evidence& evidence) {
  for (size_t i = 0; i < cameras_; ++i) {
    const auto fix = [&](int index) {
      system_(index, index) += kFixed;
      gradient_[index] = 0;
    };
    for (size_t c = 0; c < kChannels; ++c)
      for (int k = 0; k < kKnots; ++k) {
        if (!evidence.shows(i)) fix(knot_index(i, c, k));
        for (size_t j = 0; j < cameras_; ++j)
          if (evidence.shows(i) && evidence.shows(j))
            system_(knot_index(i, c, k), knot_index(j, c, k)) += kSumStiffness;
      }
    for (int n = 0; n < 2; ++n)
      if (!evidence.shows(i)) fix(falloff_index(i) + n);
  }
}

/// The falloffs come last in the factor, so its upper left part solves for the curves alone, and its lower
/// right part is the root of what the overlaps determine of the falloffs.
void JointFit::solve(double rate) {
  const auto& lower = factor_.matrixLLT();
  const int falloffs = length_ - knots_;
  const auto lower_right = lower.bottomRightCorner(falloffs, falloffs).triangularView<Eigen::Lower>();
  factor_.matrixL().solveInPlace(gradient_);
  step_ = gradient_;
  lower_right.transpose().solveInPlace(step_.tail(falloffs));
  const double shown =
      (lower_right.transpose() * (state_.tail(falloffs) + step_.tail(falloffs))).squaredNorm() / falloffs;
  falloff_shown_ = with_falloff_ && shown > (falloff_shown_ ? kFalloffShowsNoMore : kFalloffShows);
  if (falloff_shown_) {
    step_.head(knots_).noalias() -=
        lower.bottomLeftCorner(falloffs, knots_).transpose() * step_.tail(falloffs);
  } else {
    step_.tail(falloffs) = -state_.tail(falloffs);
  }
  lower.topLeftCorner(knots_, knots_)
      .triangularView<Eigen::Lower>()
      .transpose()
      .solveInPlace(step_.head(knots_));
  state_ += rate * step_;
}

}  // namespace svchain::photometric
