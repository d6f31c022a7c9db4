#include "algorithms/registration/consensus.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>

namespace svchain::registration {

namespace {

constexpr int kTrials = 3000;
constexpr size_t kFewest = 7;
constexpr double kLeastShare = 0.25;   // of all candidates: fewer agree by chance, on charts above all
constexpr double kTolerance = 3;       // in standard deviations of the noise
constexpr double kCurvature = 0.1;     // tolerance also grows by this part of a correction: it is not linear
constexpr double kWorthOfACorner = 2;  // against the prior's half squares: log of window to tolerance

using Correction = Eigen::Matrix<double, 16, 1>;

class Vote {
 public:
  Vote(const std::vector<LinearPair>& pairs, double noise_m) : pairs_(pairs), noise_m_(noise_m) {}

  /// How many corners agree with a correction, those that agree well counting more; with `agreeing`, also
  /// which.
  double count(const Correction& x, std::vector<size_t>* agreeing) const {
    double sum = 0;
    for (size_t i = 0; i < pairs_.size();) {
      double best = 0;
      size_t chosen = 0;
      const size_t corner = pairs_[i].corner;
      for (; i < pairs_.size() && pairs_[i].corner == corner; ++i) {
        const double agreement = agreement_of(pairs_[i].disagreement, x);
        if (agreement <= best) continue;
        best = agreement;
        chosen = i;
      }
      sum += best;
      if (agreeing && best > 0) agreeing->push_back(chosen);
    }
    return sum;
  }

 private:
  double agreement_of(const Disagreement& d, const Correction& x) const {
    const Eigen::Vector2d moved = d.jacobian * x;
    const double tolerance = kTolerance * noise_m_ + kCurvature * moved.norm();
    return 1 - (d.metres + moved).squaredNorm() / (tolerance * tolerance);
  }

  const std::vector<LinearPair>& pairs_;
  double noise_m_;
};

/// The most probable correction by the chosen pairs, and half the squares by which it strains the prior.
struct Guess {
  Correction x;
  double strain = 0;
};

Guess most_probable(const std::vector<LinearPair>& pairs, const std::array<size_t, 3>& chosen,
                    const PairCovariance& prior, double noise_m) {
  Eigen::Matrix<double, 6, 16> j;
  Eigen::Matrix<double, 6, 1> r;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Disagreement& d = pairs[chosen[static_cast<size_t>(i)]].disagreement;
    j.middleRows<2>(2 * i) = d.jacobian;
    r.segment<2>(2 * i) = d.metres;
  }
  const Eigen::Matrix<double, 16, 6> spread = prior * j.transpose();
  const Eigen::Matrix<double, 6, 6> explained = j * spread;
  Eigen::Matrix<double, 6, 6> total = explained;
  total.diagonal().array() += noise_m * noise_m;
  const Eigen::Matrix<double, 6, 1> y = total.ldlt().solve(r);
  return {-spread * y, 0.5 * y.dot(explained * y)};
}

}  // namespace

std::vector<size_t> consensus(const std::vector<LinearPair>& pairs, const PairCovariance& prior,
                              double noise_m) {
  if (pairs.size() < kFewest) return {};
  const Vote vote(pairs, noise_m);
  std::minstd_rand random(1);
  Correction best = Correction::Zero();
  double best_score = kWorthOfACorner * vote.count(best, nullptr);
  for (int trial = 0; trial < kTrials; ++trial) {
    std::array<size_t, 3> chosen;
    for (auto& one : chosen) one = random() % pairs.size();
    const auto corner = [&](size_t i) { return pairs[chosen[i]].corner; };
    if (corner(0) == corner(1) || corner(1) == corner(2) || corner(0) == corner(2)) continue;
    const Guess guess = most_probable(pairs, chosen, prior, noise_m);
    const double score = kWorthOfACorner * vote.count(guess.x, nullptr) - guess.strain;
    if (score <= best_score) continue;
    best_score = score;
    best = guess.x;
  }
  std::vector<size_t> agreeing;
  vote.count(best, &agreeing);
  const auto fewest = static_cast<size_t>(kLeastShare * static_cast<double>(pairs.size()));
  if (agreeing.size() < std::max(kFewest, fewest)) agreeing.clear();
  return agreeing;
}

}  // namespace svchain::registration
