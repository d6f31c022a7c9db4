#include "algorithms/geometry/pose_from_homography.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace svchain::geometry {

std::optional<Rigid3> pose_from_homography(const Eigen::Matrix3d& ray_from_ground) {
  constexpr double kSingular = 1e-9;
  const Eigen::Matrix3d scaled = ray_from_ground / ray_from_ground.norm();
  if (!scaled.allFinite() || !(std::abs(scaled.determinant()) > kSingular)) return std::nullopt;

  // The nearest matrix with orthonormal columns is the orthogonal part of the polar decomposition, A
  // (A'A)^-1/2.
  const Eigen::Matrix<double, 3, 2> columns = scaled.leftCols<2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> gram(columns.transpose() * columns);
  const Eigen::Matrix<double, 3, 2> axes = columns * gram.operatorInverseSqrt();
  const double scale = gram.operatorSqrt().trace() / 2;

  Eigen::Matrix3d rotation;  // camera from vehicle
  rotation << axes, axes.col(0).cross(axes.col(1));
  Eigen::Vector3d translation = scaled.col(2) / scale;
  const double height = -rotation.col(2).dot(translation);
  if (height < 0) {  // the same homography times -1: the camera's mirror image below the ground
    rotation.leftCols<2>() *= -1;
    translation *= -1;
  }
  return Rigid3{Eigen::Quaterniond(rotation), translation}.inverse();
}

}  // namespace svchain::geometry
