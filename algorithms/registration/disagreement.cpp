#include "algorithms/registration/disagreement.h"

#include <Eigen/LU>

namespace svchain::registration {

namespace {

constexpr double kDelta = 1e-6;

}  // namespace

DisagreementMeter::DisagreementMeter(const Perspectives& starts, const Steps& steps) {
  for (size_t camera = 0; camera < 4; ++camera) {
    Inverses& inverses = ground_from_ray_[camera];
    inverses.here = stepped(starts[camera], steps[camera]).inverse();
    for (Eigen::Index i = 0; i < 8; ++i) {
      const Step little = kDelta * Step::Unit(i);
      inverses.ahead[i] = stepped(starts[camera], steps[camera] + little).inverse();
      inverses.behind[i] = stepped(starts[camera], steps[camera] - little).inverse();
    }
  }
}

Eigen::Vector2d DisagreementMeter::metres(const RayPair& pair) const {
  return ground_of(ground_from_ray_[pair.b].here, pair.ray_b) - ground_a(pair);
}

Eigen::Vector2d DisagreementMeter::ground_a(const RayPair& pair) const {
  return ground_of(ground_from_ray_[pair.a].here, pair.ray_a);
}

Disagreement DisagreementMeter::measure(const RayPair& pair) const {
  Disagreement found{metres(pair), {}};
  const Inverses& a = ground_from_ray_[pair.a];
  const Inverses& b = ground_from_ray_[pair.b];
  for (Eigen::Index i = 0; i < 8; ++i) {
    found.jacobian.col(i) =
        (ground_of(a.behind[i], pair.ray_a) - ground_of(a.ahead[i], pair.ray_a)) / (2 * kDelta);
    found.jacobian.col(8 + i) =
        (ground_of(b.ahead[i], pair.ray_b) - ground_of(b.behind[i], pair.ray_b)) / (2 * kDelta);
  }
  return found;
}

}  // namespace svchain::registration
