#pragma once
// A camera's pose from corners whose places are known, the paper's way: four corners at a time, direct linear
// transformation through the lens's rays, projection on the orthogonal matrices, the corners that agree
// counted, about a hundred times (RANSAC: Fischler and Bolles, CACM 24(6), 1981); the pose most agree with is
// then refined through the lens. Pure: the same corners give the same pose.

#include <optional>
#include <vector>

#include "algorithms/geometry/refine_pose.h"

namespace svchain::calibration {

struct AgreedPose {
  geometry::Rigid3 vehicle_from_camera;
  std::vector<bool> agrees;  // of each sighting
};

/// Sightings of places on the ground. Nothing with fewer than four, or where no pose has most of them agree.
std::optional<AgreedPose> agreed_pose(const geometry::Lens& lens,
                                      const std::vector<geometry::Sighting>& sightings);

}  // namespace svchain::calibration
