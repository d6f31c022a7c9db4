#pragma once
// How far apart on the ground two cameras put what they both see, and how that changes with their matrices.
// Plain values and pure functions.

#include <array>

#include "algorithms/registration/perspective.h"

namespace svchain::registration {

using Steps = std::array<Step, 4>;

/// A point of the ground as cameras `a` and `b` see it, by rays in their own frames.
struct RayPair {
  size_t a = 0;
  size_t b = 0;
  Eigen::Vector3d ray_a;
  Eigen::Vector3d ray_b;
};

/// The ground point where a ray ends. A ray that does not go down ends nowhere, far beyond all.
inline Eigen::Vector2d ground_of(const Eigen::Matrix3d& ground_from_ray, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d ground = ground_from_ray * ray;
  if (!(ground.z() > 0)) return Eigen::Vector2d::Constant(1e9);
  return ground.hnormalized();
}

/// Disagreement in metres, b's point minus a's, and its derivatives by a's step, then by b's.
struct Disagreement {
  Eigen::Vector2d metres;
  Eigen::Matrix<double, 2, 16> jacobian;
};

/// Measures about four matrices, each given as a start and a step from it. Keeps copies.
class DisagreementMeter {
 public:
  DisagreementMeter(const Perspectives& starts, const Steps& steps);

  Eigen::Vector2d metres(const RayPair& pair) const;
  /// Where a puts the point.
  Eigen::Vector2d ground_a(const RayPair& pair) const;
  Disagreement measure(const RayPair& pair) const;

 private:
  struct Inverses {
    Eigen::Matrix3d here;
    std::array<Eigen::Matrix3d, 8> ahead, behind;  // a little step along each of the eight numbers
  };
  std::array<Inverses, 4> ground_from_ray_;
};

}  // namespace svchain::registration
