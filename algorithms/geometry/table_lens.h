#pragma once
// A lens given by its maker's table of image heights: r in px by monotone cubic interpolation, u = r a + cx,
// v = r b + cy with (a, b) the unit direction of the ray's (x, y). Valid to the end of the table. Immutable.

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens.h"
#include "algorithms/geometry/lens_table.h"

namespace svchain::geometry {

class TableLens : public Lens {
 public:
  /// The table must be free of faults; the largest angle is cut down to its end where that is smaller.
  TableLens(LensTable table, double pixel_um, Eigen::Vector2d centre_px,
            double max_angle_rad = kUsualMaxAngleRad);

  std::string model() const override { return "table"; }
  double max_angle_rad() const override { return max_angle_rad_; }
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const override;
  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const override;

  const LensTable& table() const { return table_; }
  double pixel_um() const { return pixel_um_; }
  const Eigen::Vector2d& centre_px() const { return centre_px_; }

 private:
  LensTable table_;
  double pixel_um_;
  Eigen::Vector2d centre_px_;
  MonotoneCurve height_mm_;  // over the angle in rad
  double max_angle_rad_;
  double max_radius_px_;
};

}  // namespace svchain::geometry
