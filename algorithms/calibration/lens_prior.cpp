#include "algorithms/calibration/lens_prior.h"

#include <cmath>
#include <numbers>

namespace svchain::calibration {

namespace {

constexpr int kRings = 8;
constexpr int kRaysOfRing = 8;
constexpr double kOutermost =
    0.95;  // of the limit: a lens of slightly other numbers may end a little earlier
constexpr double kLostPx = 100;

}  // namespace

LensPrior::LensPrior(const geometry::Lens& known, double sigma_px) {
  for (int ring = 1; ring <= kRings; ++ring) {
    const double angle = kOutermost * known.max_angle_rad() * ring / kRings;
    for (int i = 0; i < kRaysOfRing; ++i) {
      const double around = 2 * std::numbers::pi * (i + 0.5 * (ring % 2)) / kRaysOfRing;
      const Eigen::Vector3d ray(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                                std::cos(angle));
      const auto pixel = known.project(ray);
      if (!pixel) continue;
      rays_.push_back(ray);
      pixels_.push_back(*pixel);
    }
  }
  weight_ = 1 / (sigma_px * std::sqrt(static_cast<double>(rays_.size())));
}

Eigen::VectorXd LensPrior::residuals(const geometry::Lens& lens) const {
  Eigen::VectorXd r(rows());
  Eigen::Index row = 0;
  for (size_t i = 0; i < rays_.size(); ++i, row += 2) {
    const auto pixel = lens.project(rays_[i]);
    r.segment<2>(row) =
        weight_ * (pixel ? Eigen::Vector2d(*pixel - pixels_[i]) : Eigen::Vector2d::Constant(kLostPx));
  }
  return r;
}

Eigen::MatrixXd LensPrior::jacobian(const geometry::LensVariations& lens, Eigen::Index parameters) const {
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(rows(), parameters);
  Eigen::Index row = 0;
  for (const auto& ray : rays_) {
    if (const auto by = lens.by_parameters(ray)) j.middleRows<2>(row) = weight_ * *by;
    row += 2;
  }
  return j;
}

}  // namespace svchain::calibration
