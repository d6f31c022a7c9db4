#pragma once
// What is known of a lens beforehand, the same for all models: its pictures of a fan of rays over the whole
// field may differ from the given lens's by so many px RMS. Immutable; any thread.

#include <Eigen/Core>
#include <vector>

#include "algorithms/geometry/lens.h"

namespace svchain::calibration {

class LensPrior {
 public:
  LensPrior(const geometry::LensPtr& known, double sigma_px);

  /// Numbers of the lens's model that may change, in the order of geometry::lens_parameters.
  Eigen::Index parameters() const { return static_cast<Eigen::Index>(steps_.size()); }
  /// A change of this one that moves the picture by about a thousandth of a pixel.
  double step(size_t parameter) const { return steps_[parameter]; }

  Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(rays_.size()); }
  /// Their squares sum up to 1 where a lens differs by the sigma.
  Eigen::VectorXd residuals(const geometry::Lens& lens) const;
  /// How much a lens differs from the known one, px RMS over the field.
  double difference_px(const geometry::Lens& lens) const { return sigma_px_ * residuals(lens).norm(); }

 private:
  double sigma_px_;
  std::vector<Eigen::Vector3d> rays_;
  std::vector<Eigen::Vector2d> pixels_;
  std::vector<double> steps_;
};

}  // namespace svchain::calibration
