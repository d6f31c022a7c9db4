#include "algorithms/registration/perspective.h"

#include <Eigen/LU>
#include <cmath>

namespace svchain::registration {

Step Uncertainty::sigma() const {
  Step sigma;
  sigma << Eigen::Vector3d::Constant(rotation_rad), Eigen::Vector3d::Constant(position_m), stretch, stretch;
  return sigma;
}

std::optional<Eigen::Matrix3d> normalised(const Eigen::Matrix3d& ray_from_ground) {
  constexpr double kSingular = 1e-9;
  const double length = std::sqrt(ray_from_ground.leftCols<2>().squaredNorm() / 2);
  const Eigen::Matrix3d scaled = ray_from_ground / length;
  const double determinant = scaled.determinant();  // minus the height above the ground
  if (!scaled.allFinite() || !(std::abs(determinant) > kSingular)) return std::nullopt;
  return determinant < 0 ? scaled : Eigen::Matrix3d(-scaled);
}

Eigen::Matrix3d stepped(const Eigen::Matrix3d& ray_from_ground, const Step& step) {
  const Eigen::Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation =
      angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  Eigen::Matrix2d stretch;
  stretch << 1 + step[6], step[7], step[7], 1 - step[6];
  Eigen::Matrix3d moved = ray_from_ground;
  moved.leftCols<2>() *= stretch;
  moved.col(2) += step.segment<3>(3);
  return rotation * moved;
}

}  // namespace svchain::registration
