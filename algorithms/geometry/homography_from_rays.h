#pragma once
// The homography between the ground and a camera's rays by direct linear transformation: ray x (H g) = 0 for
// every pair, the ground's coordinates normalised first (Hartley, PAMI 19(6), 1997). Rays may point anywhere,
// so a fisheye's whole field serves. Pure.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace svchain::geometry {

struct GroundRay {
  Eigen::Vector2d ground_m;
  Eigen::Vector3d ray;  // in the camera's frame, of any length
};

/// `ray_from_ground` as pose_from_homography takes it, such that the rays point away from the camera. Nothing
/// with fewer than four pairs, or where they leave it open (three of four in a line).
std::optional<Eigen::Matrix3d> homography_from_rays(const std::vector<GroundRay>& pairs);

}  // namespace svchain::geometry
