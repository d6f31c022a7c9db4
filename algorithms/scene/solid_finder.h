#pragma once
// Which pixels of a live picture show something that stands up: runs of neighbours are passed over where none
// of their rays can hit anything, the others' rays are cast. Holds a ray for each pixel (12 bytes), if the
// scene has anything that stands. Immutable, any thread; cover() allocates nothing.

#include <cstdint>
#include <vector>

#include "algorithms/geometry/pose2.h"
#include "algorithms/scene/solids.h"

namespace svchain::scene {

class SolidFinder {
 public:
  SolidFinder(const Scene& scene, size_t camera);

  /// Replaces the light of those of `count` pixels from `first` on (numbered row by row) that look at
  /// something, from a vehicle at the pose. Light as Sensor takes it.
  void cover(const Pose2& world_from_vehicle, size_t first, size_t count, uint64_t* light) const;

 private:
  /// The cone about the rays of kRun pixels.
  struct Run {
    Eigen::Vector3f axis;
    float cos_half = -1, sin_half = 0;
  };
  bool may_hit(const Run& run, const Turn& turn, const Eigen::Vector3d& eye) const;

  Solids solids_;
  Eigen::Vector3d eye_in_vehicle_;
  std::vector<Eigen::Vector3f> rays_;  // in the vehicle's frame; zero where the lens does not reach
  std::vector<Run> runs_;
};

}  // namespace svchain::scene
