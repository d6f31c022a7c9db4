#pragma once
// A viewpoint's picture as OpenGL projects it: row 0 of the framebuffer is the picture's upper row, so that
// it is read back as it is stored. A triangle that is counter-clockwise in the world is clockwise there. No
// far plane. Plain function, any thread.

#include <Eigen/Core>

#include "algorithms/bowl/viewpoint.h"

namespace svchain::gl {

inline Eigen::Matrix4d clip_from_vehicle(const bowl::Perspective& perspective, const Eigen::Vector2i& size_px,
                                         double near_m) {
  const Eigen::Matrix3d picture_from_vehicle = perspective.vehicle_from_picture().transpose();
  Eigen::Matrix<double, 3, 4> seen;  // to the right, downwards, along the sight
  seen << picture_from_vehicle, -picture_from_vehicle * perspective.eye();
  Eigen::Matrix4d clip;
  clip.row(0) = 2 * perspective.focal_px() / size_px.x() * seen.row(0);
  clip.row(1) = 2 * perspective.focal_px() / size_px.y() * seen.row(1);
  clip.row(2) = seen.row(2);
  clip(2, 3) -= 2 * near_m;
  clip.row(3) = seen.row(2);
  return clip;
}

}  // namespace svchain::gl
