#pragma once
// Which cameras show a point of the world, where in their images, and how they blend: the shares of
// camera_shares.h, corrected by how far inside its picture each of the two sees the point. Keeps lenses
// alive; immutable, any thread.

#include <array>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/blend_shape.h"
#include "algorithms/synthesis/camera_reach.h"
#include "algorithms/synthesis/camera_shares.h"

namespace svchain::synthesis {

struct PointSources {
  int count = 0;  // 0 to 2; two are neighbours, the clockwise first one first
  std::array<int, 2> camera = {};
  std::array<Eigen::Vector2d, 2> image_px;
  int first_weight = 255;  // of two: the share of the first in 255ths, 1 to 254, or 0 and 255 if binary
};

class SourceFinder {
 public:
  /// One `ray_from_point` for each camera of the rig.
  SourceFinder(const geometry::Rig& rig, const std::vector<RayFromPoint>& ray_from_point,
               const BlendShape& shape);
  /// As the poses of the rig say.
  SourceFinder(const geometry::Rig& rig, const BlendShape& shape);

  /// Of a point that, seen from above, is not under the vehicle (vehicle frame, metres).
  PointSources find(const Eigen::Vector3d& point) const;
  /// The same, but with both cameras wherever both see the point, even one that has no share in it (a weight
  /// of 0 or 255): for interpolating between points.
  PointSources find_pair(const Eigen::Vector3d& point) const;

 private:
  PointSources find(const Eigen::Vector3d& point, int main, int other, const CameraShares& shares) const;

  geometry::Vehicle vehicle_;
  BlendShape shape_;
  std::vector<CameraReach> reaches_;
};

}  // namespace svchain::synthesis
