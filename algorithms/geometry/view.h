#pragma once
// The composite seen from straight above: forward is up, left is left. Plain value.

#include <Eigen/Core>

#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

struct View {
  Eigen::Vector2i size_px = {880, 1080};
  double metres_per_px = 0.01;
  Eigen::Vector2d centre_m = {0, 0};

  /// Ground point (x, y in the vehicle's frame) at the centre of output pixel (i, j), contracts: "View".
  Eigen::Vector2d ground_from_pixel(const Eigen::Vector2d& pixel) const {
    return {centre_m.x() + (size_px.y() / 2.0 - 0.5 - pixel.y()) * metres_per_px,
            centre_m.y() + (size_px.x() / 2.0 - 0.5 - pixel.x()) * metres_per_px};
  }
  Eigen::Vector2d pixel_from_ground(const Eigen::Vector2d& ground) const {
    return {size_px.x() / 2.0 - 0.5 - (ground.y() - centre_m.y()) / metres_per_px,
            size_px.y() / 2.0 - 0.5 - (ground.x() - centre_m.x()) / metres_per_px};
  }
};

/// Scale at which the vehicle's length takes 45 % of the view's height.
inline double default_metres_per_px(const Vehicle& vehicle, const Eigen::Vector2i& size_px) {
  return vehicle.length_m / (0.45 * size_px.y());
}

}  // namespace svchain::geometry
