#include "algorithms/registration/joint_fit.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace svchain::registration {

namespace {

using Vector32 = Eigen::Matrix<double, 32, 1>;

constexpr double kCauchy = 2;  // in standard deviations of the noise

Vector32 stacked(const Steps& steps) {
  Vector32 x;
  x << steps[0], steps[1], steps[2], steps[3];
  return x;
}

Steps unstacked(const Vector32& x) {
  return {x.segment<8>(0), x.segment<8>(8), x.segment<8>(16), x.segment<8>(24)};
}

struct Problem {
  const Perspectives& starts;
  Vector32 information;  // of the prior
  const std::vector<RayPair>& pairs;
  double noise_m;

  double cost(const Vector32& x) const {
    const DisagreementMeter meter(starts, unstacked(x));
    double sum = x.dot(information.cwiseProduct(x));
    for (const auto& pair : pairs) {
      sum += kCauchy * kCauchy *
             std::log1p(meter.metres(pair).squaredNorm() / (noise_m * noise_m * kCauchy * kCauchy));
    }
    return sum;
  }

  /// The normal equations with each pair weighted by its loss.
  void linearise(const Vector32& x, JointCovariance& normal, Vector32& gradient) const {
    const DisagreementMeter meter(starts, unstacked(x));
    normal = information.asDiagonal();
    gradient = information.cwiseProduct(x);
    for (const auto& pair : pairs) {
      const Disagreement d = meter.measure(pair);
      const double weight = 1 / (noise_m * noise_m + d.metres.squaredNorm() / (kCauchy * kCauchy));
      const Eigen::Index from[2] = {static_cast<Eigen::Index>(8 * pair.a),
                                    static_cast<Eigen::Index>(8 * pair.b)};
      for (int i = 0; i < 2; ++i) {
        const auto ji = d.jacobian.middleCols<8>(8 * i);
        gradient.segment<8>(from[i]) += weight * ji.transpose() * d.metres;
        for (int k = 0; k < 2; ++k) {
          normal.block<8, 8>(from[i], from[k]) += weight * ji.transpose() * d.jacobian.middleCols<8>(8 * k);
        }
      }
    }
  }
};

}  // namespace

JointFit fit_jointly(const Perspectives& starts, const Step& sigma, const Steps& steps,
                     const std::vector<RayPair>& pairs, double noise_m) {
  constexpr int kMostRounds = 30;
  constexpr double kEnough = 1e-5;  // of the cost, in one round
  constexpr double kMostDamping = 1e8;
  const Vector32 information = sigma.cwiseAbs2().cwiseInverse().replicate<4, 1>();
  const Problem problem{starts, information, pairs, noise_m};
  Vector32 x = stacked(steps);
  double cost = problem.cost(x);
  double damping = 1e-4;
  JointCovariance normal;
  Vector32 gradient;
  for (int round = 0; round < kMostRounds && damping < kMostDamping; ++round) {
    problem.linearise(x, normal, gradient);
    double gain = 0;
    for (bool better = false; !better && damping < kMostDamping; damping *= better ? 0.1 : 10) {
      JointCovariance damped = normal;
      damped.diagonal() *= 1 + damping;
      const Vector32 tried = x - damped.ldlt().solve(gradient);
      const double tried_cost = problem.cost(tried);
      better = tried_cost < cost;  // false for NaN too
      if (!better) continue;
      gain = cost - tried_cost;
      cost = tried_cost;
      x = tried;
    }
    if (gain <= kEnough * cost) break;
  }
  problem.linearise(x, normal, gradient);
  return {unstacked(x), normal.ldlt().solve(JointCovariance::Identity())};
}

}  // namespace svchain::registration
