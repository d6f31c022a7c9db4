#pragma once
// The paper's optimal perspective matrices: all four at once, such that matched features fall on one another
// on the ground. Minimises
//   sum over pairs of c^2 log(1 + |disagreement|^2 / (noise^2 c^2)) + sum over cameras of |step / sigma|^2
// by Levenberg-Marquardt: Cauchy's loss keeps false matches from pulling, and the second sum keeps scale and
// place, which features cannot tell, and all that is far from any feature, near the start. Pure.

#include <Eigen/Core>
#include <vector>

#include "algorithms/registration/disagreement.h"

namespace svchain::registration {

using JointCovariance = Eigen::Matrix<double, 32, 32>;  // of the steps of camera 0, 1, 2, 3

struct JointFit {
  Steps steps;
  JointCovariance covariance;
};

/// `steps` to begin with; they count from `starts`, about which `sigma` tells how far these may be off
/// (positive numbers). Noise in metres: of a true match's disagreement.
JointFit fit_jointly(const Perspectives& starts, const Step& sigma, const Steps& steps,
                     const std::vector<RayPair>& pairs, double noise_m);

}  // namespace svchain::registration
