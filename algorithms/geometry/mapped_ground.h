#pragma once
// How a foreign calibration maps the ground to one camera: by an ideal pinhole image in between, ground ->
// homography -> ray -> lens. What no homography can hold, that the camera is a rigid thing, is put back: a
// pose is found for it.

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

class MappedGround {
 public:
  /// The ideal image's homography from (x, y, 1) on the ground, metres; its pinhole matrix; its size; the
  /// rectangle of ground that is shown by this camera.
  MappedGround(const Eigen::Matrix3d& ideal_from_ground, const Eigen::Matrix3d& ideal_from_ray,
               Eigen::Vector2i ideal_size_px, const Eigen::AlignedBox2d& shown_m);

  /// Where the foreign calibration sees a ground point; nothing where it does not show it.
  std::optional<Eigen::Vector2d> see(const Eigen::Vector2d& ground, const Camera& camera) const;
  /// (x, y, 1) -> ray in the camera's frame, of a factor such that the middle of what is shown is in front.
  const Eigen::Matrix3d& ray_from_ground() const { return ray_from_ground_; }
  const Eigen::AlignedBox2d& shown_m() const { return shown_m_; }

 private:
  Eigen::Matrix3d ray_from_ground_;
  Eigen::Matrix3d ideal_from_ray_;
  Eigen::Vector2i ideal_size_px_;
  Eigen::AlignedBox2d shown_m_;
};

/// Gives `camera` (name, image size and lens are set) the pose that agrees best with the map over the ground
/// it shows. Faults, under `file`: a singular map, a mirrored one, one that looks inwards or shows next to
/// nothing of the ground. Returns what is left between map and pose, RMS px.
Result<double> pose_camera(const MappedGround& map, const std::string& file, Camera& camera);

}  // namespace svchain::geometry
