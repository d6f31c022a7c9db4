#include "usecases/svchain/cost_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace svchain::program {

namespace {

constexpr int kTerms = 4;
/// The earlier of two that explain the same is taken.
constexpr std::array<double CallCost::*, kTerms> kTerm = {&CallCost::per_call, &CallCost::per_output_px,
                                                          &CallCost::per_result, &CallCost::per_input_px};
constexpr double kWorthATerm = 0.8;      // of the squared deviations must be all that is left
constexpr double kNotWorthATerm = 1e-6;  // squared relative deviation for each measurement: 0.1 %
constexpr double kTellsApart = 1e-6;     // of columns of length 1

using Terms = unsigned;  // a set of them, a bit each

/// What each term counts, over the time: the fit is to be 1 everywhere.
Eigen::MatrixXd relative_counts(const std::vector<MeasuredCalls>& measured) {
  Eigen::MatrixXd counts(static_cast<Eigen::Index>(measured.size()), kTerms);
  for (size_t i = 0; i < measured.size(); ++i) {
    const MeasuredCalls& m = measured[i];
    counts.row(static_cast<Eigen::Index>(i)) =
        Eigen::RowVector4d(1, m.output_px, m.sent ? 1 : 0, m.input_px) / m.median_ns;
  }
  return counts;
}

/// Least squares by these terms alone; nothing where they cannot be told apart or one is negative.
std::optional<Eigen::Vector4d> solve(const Eigen::MatrixXd& counts, Terms terms) {
  std::vector<int> columns;
  for (int t = 0; t < kTerms; ++t) {
    if (terms & (1U << t)) columns.push_back(t);
  }
  Eigen::MatrixXd chosen = counts(Eigen::all, columns);
  const Eigen::RowVectorXd length = chosen.colwise().norm();
  if (length.minCoeff() <= 0) return std::nullopt;
  chosen.array().rowwise() /= length.array();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(chosen.rows(), chosen.cols());
  decomposed.setThreshold(kTellsApart).compute(chosen);
  if (decomposed.rank() < chosen.cols()) return std::nullopt;
  const Eigen::VectorXd solution = decomposed.solve(Eigen::VectorXd::Ones(chosen.rows()));
  if (solution.minCoeff() < 0) return std::nullopt;
  Eigen::Vector4d figures = Eigen::Vector4d::Zero();
  for (size_t i = 0; i < columns.size(); ++i) {
    const auto c = static_cast<Eigen::Index>(i);
    figures[columns[i]] = solution[c] / length[c];
  }
  return figures;
}

/// All sets of terms, small ones first, then in the order of kTerm.
std::vector<Terms> sets_of_terms() {
  std::vector<Terms> sets;
  for (Terms terms = 1; terms < 1U << kTerms; ++terms) sets.push_back(terms);
  std::stable_sort(sets.begin(), sets.end(),
                   [](Terms a, Terms b) { return std::popcount(a) < std::popcount(b); });
  return sets;
}

}  // namespace

/// The least squares solution without negative figures is the plain one of some set of terms; there are few.
CostFit fit_cost(const std::vector<MeasuredCalls>& measured) {
  const Eigen::MatrixXd counts = relative_counts(measured);
  const auto deviations = [&](const Eigen::Vector4d& figures) -> Eigen::VectorXd {
    return (counts * figures).array() - 1;
  };
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (const Terms terms : sets_of_terms()) {
    const auto figures = solve(counts, terms);
    if (!figures) continue;
    const double margin = kNotWorthATerm * static_cast<double>(measured.size());
    const double left = deviations(*figures).squaredNorm(), before = deviations(best).squaredNorm();
    if (left < kWorthATerm * before - margin) best = *figures;
  }
  CostFit fit;
  for (int t = 0; t < kTerms; ++t) fit.cost_ns.*kTerm[static_cast<size_t>(t)] = best[t];
  fit.largest_deviation = deviations(best).cwiseAbs().maxCoeff();
  return fit;
}

}  // namespace svchain::program
