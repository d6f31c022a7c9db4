#pragma once
// The dark footprint of the car on the ground, soft towards the outside. No camera sees the ground within the
// vehicle's rectangle, so the shadow hides it. With p a point on the ground, h half the vehicle's length and
// width, r = 0.1 width the corners' radius:
//
//   q = |p| - h + r;  d = |max(q, 0)| + min(max(q_x, q_y), 0) - r         signed distance, negative inside
//   shadow = 1 - smoothstep(0, 0.22 width, d)
//
// What is drawn under the car is black with this alpha.

#include <Eigen/Core>
#include <algorithm>

#include "algorithms/car/lighting.h"
#include "algorithms/geometry/rig.h"

namespace svchain::car {

class ContactShadow {
 public:
  explicit ContactShadow(const geometry::Vehicle& vehicle)
      : half_(Eigen::Vector2d(vehicle.length_m, vehicle.width_m).cast<float>() / 2),
        width_(static_cast<float>(vehicle.width_m)) {}

  /// 0 in full light to 1, at a point of the ground in the vehicle's frame.
  float shadow_at(const Eigen::Vector2f& ground) const {
    const Eigen::Vector2f q = (ground.cwiseAbs() - half_).array() + radius();
    const float distance = q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0f) - radius();
    return 1 - smoothstep(0, soft(), distance);
  }
  /// Half the sides of the rectangle outside of which there is none.
  Eigen::Vector2f reach() const { return half_.array() + soft(); }

  // The formula's h, r and the width of the shadow's edge.
  const Eigen::Vector2f& half() const { return half_; }
  float radius() const { return 0.1f * width_; }
  float soft() const { return kSoftness * width_; }

 private:
  static constexpr float kSoftness = 0.22f;

  Eigen::Vector2f half_;
  float width_;
};

}  // namespace svchain::car
