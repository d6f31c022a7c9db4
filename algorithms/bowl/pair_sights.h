#pragma once
// What two neighbouring cameras make of a point of the bowl. By camera_shares.h each quarter of the world
// around the vehicle belongs to one pair of neighbours: pair k is cameras k and (k + 1) % 4, clockwise from
// front and right ahead on the right. Keeps lenses alive; immutable, any thread.

#include <array>
#include <optional>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/point_sources.h"

namespace svchain::bowl {

/// The pair of the quarter a ground point (metres) lies in.
int pair_at(const Eigen::Vector2d& ground);

struct PairSight {
  std::array<std::optional<Eigen::Vector2d>, 2> pixel;  // where each of the two sees it, if it does
  int first_weight = -1;                                // 0 to 255; -1: not shown by either

  bool shown() const { return first_weight >= 0; }
  bool sees(int which) const { return shown() && pixel[which]; }
};

class PairSights {
 public:
  /// Four cameras.
  PairSights(const geometry::Rig& rig, const BowlSurface& surface, const synthesis::BlendShape& shape);

  /// A point of the bowl that is not under the vehicle, in a pair's quarter, its borders included.
  PairSight at(int pair, const Eigen::Vector2d& ground) const;

 private:
  std::optional<Eigen::Vector2d> see(int camera, const Eigen::Vector3d& point) const;

  geometry::Rig rig_;
  BowlSurface surface_;
  synthesis::SourceFinder finder_;
};

}  // namespace svchain::bowl
