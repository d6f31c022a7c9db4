#pragma once
// What one camera sees of the world, and how far inside its picture: a camera fades towards the border of
// its image and towards the limit of its lens, and where its own vehicle stands in the way, so that no seam
// shows where its picture ends. Keeps the lens alive; immutable.

#include <Eigen/Core>
#include <optional>

#include "algorithms/geometry/rig.h"

namespace svchain::synthesis {

/// (x, y, z, 1) in the vehicle's frame, metres, to a ray in a camera's, up to a factor above 0.
using RayFromPoint = Eigen::Matrix<double, 3, 4>;

class CameraReach {
 public:
  struct Seen {
    Eigen::Vector2d pixel;  // within 0..width-1, 0..height-1
    double fade = 0;        // 1 well inside the picture, falling smoothly to 0 where it ends
  };

  /// Fading takes this share of the image's shorter side ...
  static constexpr double kBorder = 0.1;
  /// ... and this angle inside the lens's largest.
  static constexpr double kLensBorderRad = 0.175;

  /// `ray_from_point` says where the camera sees a point; its pose is taken for what its own vehicle hides,
  /// and for nothing else.
  CameraReach(const geometry::Camera& camera, const RayFromPoint& ray_from_point,
              const geometry::Vehicle& vehicle);

  /// Where the camera sees a point (vehicle frame, metres), nothing where it does not.
  std::optional<Seen> see(const Eigen::Vector3d& point) const;

 private:
  geometry::LensPtr lens_;
  RayFromPoint ray_from_point_;
  geometry::Vehicle vehicle_;
  Eigen::Vector2d position_;  // from above
  Eigen::Vector2d last_pixel_;
  double border_px_;
  double cos_lens_border_;  // of the angle at which the lens begins to fade
};

}  // namespace svchain::synthesis
