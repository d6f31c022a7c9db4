#include "algorithms/geometry/homography_from_rays.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace svchain::geometry {

namespace {

/// Moves the mean to the origin and the mean distance from it to the root of 2.
Eigen::Matrix3d normalisation(const std::vector<GroundRay>& pairs) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& pair : pairs) mean += pair.ground_m / static_cast<double>(pairs.size());
  double distance = 0;
  for (const auto& pair : pairs)
    distance += (pair.ground_m - mean).norm() / static_cast<double>(pairs.size());
  const double scale = distance > 0 ? std::sqrt(2) / distance : 1;
  Eigen::Matrix3d n;
  n << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
  return n;
}

}  // namespace

std::optional<Eigen::Matrix3d> homography_from_rays(const std::vector<GroundRay>& pairs) {
  constexpr double kOpen = 1e-9;  // second least eigenvalue over the greatest
  if (pairs.size() < 4) return std::nullopt;
  const Eigen::Matrix3d normalised = normalisation(pairs);
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  Matrix9 gram = Matrix9::Zero();
  for (const auto& pair : pairs) {
    const Eigen::Vector3d ground = normalised * pair.ground_m.homogeneous();
    const Eigen::Vector3d ray = pair.ray.normalized();
    Eigen::Matrix3d cross;  // cross * v = ray x v
    cross << 0, -ray.z(), ray.y(), ray.z(), 0, -ray.x(), -ray.y(), ray.x(), 0;
    Eigen::Matrix<double, 3, 9> rows;
    for (int column = 0; column < 3; ++column) rows.middleCols<3>(3 * column) = ground[column] * cross;
    gram += rows.transpose() * rows;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix9> solver(gram);
  const auto& values = solver.eigenvalues();
  if (!values.allFinite() || values[1] < kOpen * values[8]) return std::nullopt;
  const Eigen::Matrix<double, 9, 1> least = solver.eigenvectors().col(0);
  Eigen::Matrix3d homography = Eigen::Map<const Eigen::Matrix3d>(least.data()) * normalised;
  double along = 0;
  for (const auto& pair : pairs) along += pair.ray.normalized().dot(homography * pair.ground_m.homogeneous());
  if (along < 0) homography = -homography;
  return homography;
}

}  // namespace svchain::geometry
