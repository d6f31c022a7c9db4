#pragma once
// The perspective matrix of a camera, the paper's: (x, y, 1) on the ground, metres, to a ray in the camera's
// frame, up to a factor. With the lens known it is the camera's pose and, in the two numbers that are left of
// its eight, a stretch of the ground that no rigid camera shows but that takes up what a lens model lacks.
// Pure.

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "algorithms/geometry/lens.h"

namespace svchain::registration {

using Perspectives = std::array<Eigen::Matrix3d, 4>;  // of front, right, rear, left

/// A small change of a perspective matrix: turn of the camera (rad) about its own axes, shift of the ground
/// against it (m) along them, stretch of the ground along x against y and along the diagonals.
using Step = Eigen::Matrix<double, 8, 1>;

/// How far a perspective matrix may be off, standard deviation of each number of a Step. Features of overlaps
/// hardly tell a stretch from a turn: where lenses are known let it be next to nothing (1e-4), and cameras
/// are rigid; 0.01 takes up what a poor lens model lacks, at the price of the picture's true shape.
struct Uncertainty {
  double rotation_rad = 0;
  double position_m = 0;
  double stretch = 0;

  Step sigma() const;
};

/// The same map with columns x and y of length 1, so that rays are in metres, and with what the camera sees
/// in front of it. Nothing where the matrix is singular.
std::optional<Eigen::Matrix3d> normalised(const Eigen::Matrix3d& ray_from_ground);

/// The normalised matrix R(turn) [A (1 + stretch) | t + shift] of [A | t].
Eigen::Matrix3d stepped(const Eigen::Matrix3d& ray_from_ground, const Step& step);

/// A camera as a map of the ground plane to its image. Shares the lens; immutable use from any thread.
struct GroundCamera {
  geometry::LensPtr lens;
  Eigen::Vector2i image_size_px = {0, 0};
  Eigen::Matrix3d ray_from_ground;

  /// Pixel of a ground point, nothing beyond the lens. The image's borders are the caller's concern.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector2d& ground) const {
    return lens->project(ray_from_ground * ground.homogeneous());
  }
};

}  // namespace svchain::registration
