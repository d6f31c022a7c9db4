#pragma once
// What `pinhole` and `mei` have in common: the ray meets the unit sphere, is seen from a point xi behind the
// sphere's centre on a plane, r = sin t / (cos t + xi), Brown's distortion bends that plane, and the focal
// lengths scale it. With xi = 0 this is a pinhole. Valid while the picture does not fold and cos t + xi is at
// least kLeastDepth of what it is on the axis. Immutable.

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/brown_distortion.h"
#include "algorithms/geometry/lens.h"

namespace svchain::geometry {

class BrownLens : public Lens {
 public:
  double max_angle_rad() const override { return max_angle_rad_; }
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const override;
  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const override;

  const Eigen::Vector2d& focal_px() const { return focal_px_; }
  const Eigen::Vector2d& centre_px() const { return centre_px_; }

 protected:
  BrownLens(double xi, Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, BrownDistortion distortion,
            double max_angle_rad);

  double xi() const { return xi_; }
  const BrownDistortion& distortion() const { return distortion_; }

 private:
  double plane_radius(double angle_rad) const;
  /// Whether rays at this angle land on the picture once, all around.
  bool serves(double angle_rad) const;

  double xi_;  // above -1
  Eigen::Vector2d focal_px_;
  Eigen::Vector2d centre_px_;
  BrownDistortion distortion_;
  double max_angle_rad_;
  double max_plane_radius_;
};

}  // namespace svchain::geometry
