#pragma once
// A scene made ready to be looked at: its ground drawn at every scale at which a camera may see it, and its
// surroundings. Made once, then immutable: any thread may look.
//
// The finest levels are windows about the origin, each twice as wide as the one before at the same number of
// texels (a clip map, Tanner et al. 1998); from the widest on each has half the texels of the one before (a
// mip map). Beyond them the ground is the panorama's.

#include <optional>
#include <vector>

#include "algorithms/scene/panorama.h"
#include "algorithms/scene/scene.h"
#include "algorithms/scene/texture.h"

namespace svchain::scene {

struct GroundLevel {
  double metres_per_texel = 0;
  double half_extent_m = 0;
  Texture texture;  // columns along x, rows along y

  /// Where to sample for a place (x or y, metres) in the world; texel centres at whole numbers.
  double texel_at(double metres) const { return (metres + half_extent_m) / metres_per_texel - 0.5; }
};

class World {
 public:
  explicit World(Scene scene);

  const Scene& scene() const { return scene_; }
  const std::vector<GroundLevel>& ground() const { return ground_; }
  const Panorama& panorama() const { return panorama_; }

  /// The level whose texels are nearest in size to the footprint among those that reach as far from the
  /// origin.
  std::optional<size_t> level_for(double footprint_m, double distance_m) const;

 private:
  Scene scene_;
  std::vector<GroundLevel> ground_;  // finest first
  Panorama panorama_;
};

}  // namespace svchain::scene
