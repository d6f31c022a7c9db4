#include "algorithms/calibration/lens_prior.h"

#include <cmath>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens_parameters.h"

namespace svchain::calibration {

namespace {

constexpr int kRings = 8;
constexpr int kRaysOfRing = 8;
constexpr double kOutermostOfLimit = 0.95;  // a lens of slightly other numbers may end a little earlier

/// A step in one parameter that moves some ray's pixel by about kStepPx.
double step_of(const geometry::Lens& lens, size_t parameter, const std::vector<Eigen::Vector3d>& rays,
               const std::vector<Eigen::Vector2d>& pixels) {
  constexpr double kStepPx = 1e-3;
  const std::vector<double> parameters = geometry::lens_parameters(lens);
  double step = 1e-7 * (1 + std::abs(parameters[parameter]));
  for (int attempt = 0; attempt < 20; ++attempt) {
    std::vector<double> changed = parameters;
    changed[parameter] += step;
    const auto moved = geometry::with_parameters(lens, changed);
    if (!moved) {
      step /= 10;
      continue;
    }
    double most_px = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
      if (const auto pixel = moved->project(rays[i])) most_px = std::max(most_px, (*pixel - pixels[i]).norm());
    }
    if (most_px > 0.3 * kStepPx && most_px < 3 * kStepPx) break;
    step *= most_px > 0 ? kStepPx / most_px : 10;
  }
  return step;
}

}  // namespace

LensPrior::LensPrior(const geometry::LensPtr& known, double sigma_px) : sigma_px_(sigma_px) {
  for (int ring = 1; ring <= kRings; ++ring) {
    const double angle = kOutermostOfLimit * known->max_angle_rad() * ring / kRings;
    for (int i = 0; i < kRaysOfRing; ++i) {
      const double around = 2 * M_PI * (i + 0.5 * (ring % 2)) / kRaysOfRing;
      const Eigen::Vector3d ray(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                                std::cos(angle));
      const auto pixel = known->project(ray);
      if (!pixel) continue;
      rays_.push_back(ray);
      pixels_.push_back(*pixel);
    }
  }
  for (size_t p = 0; p < geometry::lens_parameters(*known).size(); ++p)
    steps_.push_back(step_of(*known, p, rays_, pixels_));
}

Eigen::VectorXd LensPrior::residuals(const geometry::Lens& lens) const {
  constexpr double kLostPx = 100;
  Eigen::VectorXd r(rows());
  const double weight = 1 / (sigma_px_ * std::sqrt(static_cast<double>(rays_.size())));
  for (size_t i = 0; i < rays_.size(); ++i) {
    const auto pixel = lens.project(rays_[i]);
    r.segment<2>(2 * static_cast<Eigen::Index>(i)) =
        weight * (pixel ? Eigen::Vector2d(*pixel - pixels_[i]) : Eigen::Vector2d::Constant(kLostPx));
  }
  return r;
}

}  // namespace svchain::calibration
