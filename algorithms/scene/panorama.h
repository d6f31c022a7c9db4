#pragma once
// What is seen where no ground is near: sky, skyline, and the ground of the far distance. Immutable, any
// thread.

#include "algorithms/scene/scene.h"
#include "algorithms/scene/texture.h"

namespace svchain::scene {

struct Panorama {
  /// Column = first_column + azimuth / radians_per_texel, azimuth counter-clockwise from the world's x,
  /// beyond a full turn by `margin_rad` on either side; row = horizon_row - elevation / radians_per_texel.
  Texture texture;
  double radians_per_texel = 0;
  double first_column = 0;
  double horizon_row = 0;
};

Panorama make_panorama(const Sky& sky, Colour ground, double margin_rad, uint64_t seed);

}  // namespace svchain::scene
