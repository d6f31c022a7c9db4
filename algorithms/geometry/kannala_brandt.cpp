#include "algorithms/geometry/kannala_brandt.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/monotone_root.h"

namespace svchain::geometry {

KannalaBrandt::KannalaBrandt(Eigen::Vector2d focal_px, Eigen::Vector2d centre_px, std::array<double, 4> k,
                             double max_angle_rad)
    : focal_px_(focal_px),
      centre_px_(centre_px),
      k_(k),
      max_angle_rad_(first_turning_point(max_angle_rad)),
      max_radius_(radius(max_angle_rad_)) {}

double KannalaBrandt::radius(double t) const {
  const double t2 = t * t;
  return t * (1 + t2 * (k_[0] + t2 * (k_[1] + t2 * (k_[2] + t2 * k_[3]))));
}

double KannalaBrandt::radius_slope(double t) const {
  const double t2 = t * t;
  return 1 + t2 * (3 * k_[0] + t2 * (5 * k_[1] + t2 * (7 * k_[2] + t2 * 9 * k_[3])));
}

double KannalaBrandt::first_turning_point(double limit_rad) const {
  constexpr int kSteps = 256;  // finer than any lens wiggles
  double rising = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = limit_rad * i / kSteps;
    if (radius_slope(angle) > 0) {
      rising = angle;
      continue;
    }
    double falling = angle;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (rising + falling);
      (radius_slope(middle) > 0 ? rising : falling) = middle;
    }
    return rising;
  }
  return limit_rad;
}

std::optional<Eigen::Vector2d> KannalaBrandt::project(const Eigen::Vector3d& ray) const {
  const double across = std::hypot(ray.x(), ray.y());
  if (across == 0) {
    if (ray.z() > 0) return centre_px_;
    return std::nullopt;
  }
  const double angle = std::atan2(across, ray.z());
  if (!(angle <= max_angle_rad_ + kAngleSlackRad)) return std::nullopt;  // also refuses NaN
  const double scale = radius(angle) / across;
  return Eigen::Vector2d(focal_px_.x() * scale * ray.x() + centre_px_.x(),
                         focal_px_.y() * scale * ray.y() + centre_px_.y());
}

std::optional<Eigen::Vector3d> KannalaBrandt::unproject(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d distorted = (pixel - centre_px_).cwiseQuotient(focal_px_);
  const double r = distorted.norm();
  if (!(r <= max_radius_ + kAngleSlackRad)) return std::nullopt;
  if (r == 0) return Eigen::Vector3d::UnitZ();
  const double angle =
      monotone_root([this](double t) { return radius(t); }, [this](double t) { return radius_slope(t); },
                    std::min(r, max_radius_), 0, max_angle_rad_, std::min(r, max_angle_rad_));
  const double across = std::sin(angle) / r;
  return Eigen::Vector3d(across * distorted.x(), across * distorted.y(), std::cos(angle));
}

}  // namespace svchain::geometry
