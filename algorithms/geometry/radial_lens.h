#pragma once
// Lenses that are the same all around their axis: u = fx r(t) a + cx, v = fy r(t) b + cy with t the angle
// from the axis and (a, b) the unit direction of the ray's (x, y). `Curve` is a plain value with
//   static constexpr const char* kModel;  // the model's name
//   double radius(double angle_rad) const;  // r, 0 on the axis
//   double slope(double angle_rad) const;   // dr/dt; not above 0 where the model no longer serves
// Immutable.

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens.h"
#include "algorithms/geometry/monotone_root.h"
#include "algorithms/geometry/off_axis.h"
#include "algorithms/geometry/served_range.h"

namespace svchain::geometry {

template <class Curve>
class RadialLens : public Lens {
 public:
  /// The largest angle is cut down to where r stops rising, if that is smaller.
  RadialLens(Curve curve, Eigen::Vector2d focal_px, Eigen::Vector2d centre_px,
             double max_angle_rad = kUsualMaxAngleRad)
      : curve_(curve),
        focal_px_(focal_px),
        centre_px_(centre_px),
        max_angle_rad_(last_served([&](double t) { return curve_.slope(t) > 0; }, max_angle_rad)),
        max_radius_(curve_.radius(max_angle_rad_)) {}

  std::string model() const override { return Curve::kModel; }
  double max_angle_rad() const override { return max_angle_rad_; }

  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& ray) const override {
    const auto seen = off_axis(ray, max_angle_rad_);
    if (!seen) return std::nullopt;
    if (seen->across == 0) return centre_px_;
    const double scale = curve_.radius(seen->angle_rad) / seen->across;
    return Eigen::Vector2d(focal_px_.x() * scale * ray.x() + centre_px_.x(),
                           focal_px_.y() * scale * ray.y() + centre_px_.y());
  }

  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const override {
    const Eigen::Vector2d distorted = (pixel - centre_px_).cwiseQuotient(focal_px_);
    const double r = distorted.norm();
    if (!(r <= max_radius_ * (1 + kAngleSlackRad))) return std::nullopt;
    if (r == 0) return Eigen::Vector3d::UnitZ();
    const double angle = monotone_root([this](double t) { return curve_.radius(t); },
                                       [this](double t) { return curve_.slope(t); }, std::min(r, max_radius_),
                                       0, max_angle_rad_, max_angle_rad_ * std::min(r / max_radius_, 1.0));
    const double across = std::sin(angle) / r;
    return Eigen::Vector3d(across * distorted.x(), across * distorted.y(), std::cos(angle));
  }

  const Curve& curve() const { return curve_; }
  const Eigen::Vector2d& focal_px() const { return focal_px_; }
  const Eigen::Vector2d& centre_px() const { return centre_px_; }

 private:
  Curve curve_;
  Eigen::Vector2d focal_px_;
  Eigen::Vector2d centre_px_;
  double max_angle_rad_;
  double max_radius_;
};

}  // namespace svchain::geometry
