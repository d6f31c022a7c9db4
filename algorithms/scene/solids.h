#pragma once
// What stands on the ground, as rays meet it. Immutable, any thread, nothing is allocated after the making.
// World frame.

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// Holds everything of one box or post.
struct Sphere {
  Eigen::Vector3d centre_m;
  double radius_m = 0;
};

/// A turn about the upright axis, counter-clockwise seen from above.
class Turn {
 public:
  explicit Turn(double yaw_rad) : c_(std::cos(yaw_rad)), s_(std::sin(yaw_rad)) {}
  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {c_ * v.x() - s_ * v.y(), s_ * v.x() + c_ * v.y(), v.z()};
  }
  Eigen::Vector3d back(const Eigen::Vector3d& v) const {
    return {c_ * v.x() + s_ * v.y(), c_ * v.y() - s_ * v.x(), v.z()};
  }

 private:
  double c_, s_;
};

class Solids {
 public:
  explicit Solids(const Scene& scene);

  /// In the order of `first_seen`'s search; empty where nothing stands.
  const std::vector<Sphere>& spheres() const { return spheres_; }

  /// The light (B, G, R, 0..255) from the nearest thing on a ray (unit) from the eye, which is outside of
  /// all. Whatever stands on the ground hides it.
  std::optional<Eigen::Vector3d> first_seen(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const;

 private:
  std::vector<Box> boxes_;
  std::vector<Turn> turns_;  // of the boxes
  std::vector<Post> posts_;
  std::vector<Sphere> spheres_;  // of the boxes, then of the posts
};

}  // namespace svchain::scene
