#pragma once
// From where the world around a vehicle is shown, how that becomes a picture, and the way from one viewpoint
// to another. Vehicle frame, metres. Plain values and functions, any thread; only check() allocates.

#include <Eigen/Core>
#include <optional>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/json/fault.h"

namespace svchain::bowl {

struct Viewpoint {
  Eigen::Vector3d eye_m = {0, 0, 0};
  Eigen::Vector3d target_m = {1, 0, 0};
  Eigen::Vector3d up = {0, 0, 1};  // of any length, not along the sight
  double field_of_view_deg = 60;   // from the picture's upper to its lower edge

  bool operator==(const Viewpoint&) const = default;
};

/// The picture from a viewpoint, a pinhole's: pixel (0, 0) is the centre of its first pixel.
class Perspective {
 public:
  /// The viewpoint must be free of faults.
  Perspective(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px);

  const Eigen::Vector3d& eye() const { return eye_; }
  double focal_px() const { return focal_px_; }
  /// To the right, downwards and along the sight, in the columns: the camera frame of geometry/lens.h.
  const Eigen::Matrix3d& vehicle_from_picture() const { return axes_; }

  /// Direction from the eye through a pixel, of any length.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d off = (pixel - centre_) / focal_px_;
    return axes_ * Eigen::Vector3d(off.x(), off.y(), 1);
  }
  /// Pixel of a point, whether on the picture or not; nothing for what is not in front of the eye.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;

 private:
  Eigen::Vector3d eye_;
  Eigen::Matrix3d axes_;
  Eigen::Vector2d centre_;
  double focal_px_;
};

/// How high a vehicle's body is taken to be, of which only length and width are known: 0.35 of its length.
double body_height_m(const geometry::Vehicle& vehicle);

/// Whether a point is in the box of the vehicle's rectangle and that height.
bool is_in_body(const geometry::Vehicle& vehicle, const Eigen::Vector3d& point);

/// Everything that is wrong with a viewpoint, each under its own pointer: numbers that are none, an eye on
/// its target, in the vehicle's body, or below ground or bowl (beyond the rim: below the rim), up along the
/// sight, a field of view that is not 1 to 150 degrees. Vehicle and surface must be free of faults.
Faults check(const Viewpoint& viewpoint, const geometry::Vehicle& vehicle, const BowlSurface& surface);

}  // namespace svchain::bowl
