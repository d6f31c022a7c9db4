#pragma once
// The ground before anything is painted on it: a grainy tile that repeats, under large blotches that do not.

#include <vector>

#include "algorithms/scene/scene.h"
#include "algorithms/scene/texture.h"

namespace svchain::scene {

class Asphalt {
 public:
  Asphalt(const Ground& ground, double finest_metres_per_texel, uint64_t seed);

  /// A square texture about the world's origin, `level` halvings coarser than the finest: what paint.h paints
  /// on.
  Texture lay(int level, int texels_a_side) const;

 private:
  Ground ground_;
  double finest_metres_per_texel_;
  uint64_t seed_;
  std::vector<std::vector<float>> grain_;  // by level, each half the side of the one before
};

}  // namespace svchain::scene
