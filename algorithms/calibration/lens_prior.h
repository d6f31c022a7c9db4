#pragma once
// What is known of a lens beforehand, the same for all models: its pictures of a fan of rays over the whole
// field may differ from the known lens's by so many px RMS. Immutable; any thread.

#include <Eigen/Core>
#include <vector>

#include "algorithms/geometry/lens_parameters.h"

namespace svchain::calibration {

class LensPrior {
 public:
  LensPrior(const geometry::Lens& known, double sigma_px);

  Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(rays_.size()); }
  /// Their squares sum up to 1 where a lens differs by the sigma.
  Eigen::VectorXd residuals(const geometry::Lens& lens) const;
  /// Of the residuals, by the lens's parameters.
  Eigen::MatrixXd jacobian(const geometry::LensVariations& lens, Eigen::Index parameters) const;

 private:
  double weight_;
  std::vector<Eigen::Vector3d> rays_;
  std::vector<Eigen::Vector2d> pixels_;
};

}  // namespace svchain::calibration
