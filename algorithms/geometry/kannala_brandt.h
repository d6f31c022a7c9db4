#pragma once
// The fisheye model of Kannala and Brandt (IEEE PAMI 28(8), 2006), radial part, as OpenCV's `fisheye` has it:
// r = t + k1 t^3 + k2 t^5 + k3 t^7 + k4 t^9 with t the angle from the optical axis, u = fx r a + cx, v = fy r
// b + cy with (a, b) the unit direction of the ray's (x, y). Valid beyond 90 degrees, as far as r rises.
// Immutable.

#include <array>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens.h"

namespace svchain::geometry {

class KannalaBrandt : public Lens {
 public:
  /// The largest angle is cut down to the first turning point of r where that is smaller.
  KannalaBrandt(Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, std::array<double, 4> k,
                double max_angle_rad = kUsualMaxAngleRad);

  std::string model() const override { return "kannala_brandt"; }
  double max_angle_rad() const override { return max_angle_rad_; }
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const override;
  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const override;

  const Eigen::Vector2d& focal_px() const { return focal_px_; }
  const Eigen::Vector2d& centre_px() const { return centre_px_; }
  const std::array<double, 4>& k() const { return k_; }

 private:
  double radius(double angle_rad) const;
  double radius_slope(double angle_rad) const;
  /// First angle up to `limit_rad` at which r stops rising, `limit_rad` where it never does.
  double first_turning_point(double limit_rad) const;

  Eigen::Vector2d focal_px_;
  Eigen::Vector2d centre_px_;
  std::array<double, 4> k_;
  double max_angle_rad_;
  double max_radius_;
};

}  // namespace svchain::geometry
