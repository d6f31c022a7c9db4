#pragma once
// Scaramuzza's model (IROS 2006) as the OCamCalib toolbox writes it to text: rho = p0 + p1 th + p2 th^2 + ...
// in px with th = t - 90 degrees, t the angle from the optical axis (its theta counts from the plane across
// the axis), then row = c rho b + d rho a + row0, column = e rho b + rho a + column0 with (a, b) the unit
// direction of the ray's (x, y), which are that toolbox's y and x. Pixels come back by solving the inverse
// polynomial. A fitted polynomial misses 0 on the axis by a fraction of a pixel; rho below 0 counts as 0, and
// pixels nearer to the centre than the rho of the axis are the axis. Valid as far as rho rises. Immutable.

#include <vector>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens.h"

namespace svchain::geometry {

class Ocam : public Lens {
 public:
  /// `affine` is c, d, e; c must differ from d e.
  Ocam(std::vector<double> inverse_polynomial, Eigen::Vector3d affine, Eigen::Vector2d centre_row_column,
       double max_angle_rad = kUsualMaxAngleRad);

  std::string model() const override { return "ocam"; }
  double max_angle_rad() const override { return max_angle_rad_; }
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const override;
  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const override;

  const std::vector<double>& inverse_polynomial() const { return inverse_polynomial_; }
  const Eigen::Vector3d& affine() const { return affine_; }
  const Eigen::Vector2d& centre_row_column() const { return centre_row_column_; }
  /// rho, not cut off at 0.
  double radius_px(double angle_rad) const;

 private:
  double radius_slope(double angle_rad) const;

  std::vector<double> inverse_polynomial_;
  Eigen::Vector3d affine_;
  Eigen::Vector2d centre_row_column_;
  Eigen::Vector2d centre_px_;
  Eigen::Matrix2d pixel_from_plane_;
  Eigen::Matrix2d plane_from_pixel_;
  double max_angle_rad_;
  double max_radius_px_;
};

}  // namespace svchain::geometry
