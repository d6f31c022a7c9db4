#pragma once
// Least squares after Levenberg and Marquardt (Marquardt, SIAM J. 11(2), 1963): Gauss-Newton steps, damped in
// proportion to the curvature until they lower the sum. Dense: for some hundred unknowns at most. `Model` has
//   Eigen::VectorXd residuals(const State&) const;
//   Eigen::MatrixXd jacobian(const State&) const;         // of the residuals, a column an unknown
//   State moved(const State&, const Eigen::VectorXd& step) const;
// Pure.

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace svchain::geometry {

/// The minimum next to the start, reached when a round lowers the sum by less than `enough` of it.
template <class Model, class State>
State least_squares(const Model& model, State state, double enough) {
  constexpr int kMostRounds = 100;
  constexpr double kMostDamping = 1e12;
  Eigen::VectorXd r = model.residuals(state);
  double damping = 1e-3;
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::MatrixXd j = model.jacobian(state);
    const Eigen::MatrixXd normal = j.transpose() * j;
    const Eigen::VectorXd gradient = j.transpose() * r;
    double gain = 0;
    for (; gain <= 0 && damping<kMostDamping; damping *= gain> 0 ? 0.1 : 10) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + 1e-12).matrix();
      State tried = model.moved(state, -damped.ldlt().solve(gradient));
      Eigen::VectorXd tried_r = model.residuals(tried);
      const double tried_gain = r.squaredNorm() - tried_r.squaredNorm();
      if (!(tried_gain > 0)) continue;  // NaN too
      gain = tried_gain;
      state = std::move(tried);
      r = std::move(tried_r);
    }
    if (gain <= enough * r.squaredNorm()) break;
  }
  return state;
}

}  // namespace svchain::geometry
