#pragma once
// What one camera sees of the ground, and how far inside its picture: a camera fades towards the border of
// its image and towards the limit of its lens, and where its own vehicle stands in the way, so that no seam
// shows where its picture ends. Keeps the lens alive; immutable.

#include <Eigen/Core>
#include <optional>

#include "algorithms/geometry/rig.h"

namespace svchain::synthesis {

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

  /// `ray_from_ground` says where the camera sees the ground (geometric_lut.h); its pose is taken for what
  /// its own vehicle hides, and for nothing else.
  CameraReach(const geometry::Camera& camera, const Eigen::Matrix3d& ray_from_ground,
              const geometry::Vehicle& vehicle);

  /// Where the camera sees a point of the ground (vehicle frame, metres, z = 0), nothing where it does not.
  std::optional<Seen> see(const Eigen::Vector2d& ground) const;

 private:
  geometry::LensPtr lens_;
  Eigen::Matrix3d ray_from_ground_;
  geometry::Vehicle vehicle_;
  Eigen::Vector2d position_;  // from above
  Eigen::Vector2d last_pixel_;
  double border_px_;
  double cos_lens_border_;  // of the angle at which the lens begins to fade
};

}  // namespace svchain::synthesis
