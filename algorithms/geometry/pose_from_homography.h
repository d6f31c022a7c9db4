#pragma once
// The pose of a camera from the homography between the ground and its rays: the first two columns of a
// homography are two columns of the rotation but for scale and noise, so the nearest rotation is found by
// projecting them on the orthogonal matrices (the paper's "projection on an orthogonal sub-space"). Pure.

#include <Eigen/Core>
#include <optional>

#include "algorithms/geometry/rigid3.h"

namespace svchain::geometry {

/// `ray_from_ground` takes (x, y, 1) on the ground, metres, to a ray in the camera's frame, up to any factor.
/// Of the two poses that explain it this is the one above the ground. Nothing where the matrix is singular.
std::optional<Rigid3> pose_from_homography(const Eigen::Matrix3d& ray_from_ground);

}  // namespace svchain::geometry
