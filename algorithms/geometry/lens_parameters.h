#pragma once
// What a calibration may change about a lens, as a list of numbers, and how pixels follow. Which numbers, by
// model; centres are x, y whatever the model's own order:
//   kannala_brandt  focal_px.x .y, centre_px.x .y, k1..k4
//   polynomial      k1..k4, aspect, centre_px.x .y
//   table           pixel_um (the height's scale), centre_px.x .y
//   ocam            rho_90_px (rho at 90 degrees, all of the polynomial scaled with it), c, e, centre_px.x
//   .y;
//                   d stays: together with e it turns the picture, which the camera's pose does too
//   mei             xi, focal_px.x .y, centre_px.x .y, k1, k2, p1, p2
//   eucm            alpha, beta, focal_px.x .y, centre_px.x .y
//   double_sphere   xi, alpha, focal_px.x .y, centre_px.x .y
//   pinhole         focal_px.x .y, centre_px.x .y, k1, k2, p1, p2, k3
// Pure functions and immutable values: any thread.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/lens.h"

namespace svchain::geometry {

std::vector<std::string> lens_parameter_names(const Lens& lens);
std::vector<double> lens_parameters(const Lens& lens);

/// The lens with other parameters, used as far as the given one at most, less where the model ends before.
/// Null where rig files could not hold the parameters or such a lens serves no picture.
LensPtr with_parameters(const Lens& lens, const std::vector<double>& parameters);

/// A pixel and how it follows the ray; the ray's length does not move it.
struct LensJacobian {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> by_ray;
};

/// By central differences, one-sided next to the rim. Nothing where the lens does not see the ray.
std::optional<LensJacobian> project_with_jacobian(const Lens& lens, const Eigen::Vector3d& ray);

/// How pixels follow a lens's parameters. Keeps a lens on either side in each of them; made once for many
/// rays.
class LensVariations {
 public:
  /// Borrows the lens.
  explicit LensVariations(const Lens& lens);

  /// d pixel / d parameter, one column each, by central differences, one-sided where there is no lens or no
  /// pixel on the other side. Nothing where the lens does not see the ray, or on neither side does.
  std::optional<Eigen::Matrix2Xd> by_parameters(const Eigen::Vector3d& ray) const;

 private:
  struct Step {
    double size;
    LensPtr after;  // null: no such lens
    LensPtr before;
  };
  const Lens& lens_;
  std::vector<Step> steps_;
};

}  // namespace svchain::geometry
