#pragma once
// The pose of one camera that best explains where points of the vehicle's frame appear in its image, through
// the lens: Levenberg-Marquardt on the six numbers of the pose, squared distances in px. Pure.

#include <vector>

#include "algorithms/geometry/lens.h"
#include "algorithms/geometry/rigid3.h"

namespace svchain::geometry {

struct Sighting {
  Eigen::Vector3d point_in_vehicle;
  Eigen::Vector2d pixel;
};

struct RefinedPose {
  Rigid3 vehicle_from_camera;
  double rms_px = 0;
};

/// At least three sightings, better many. `start` must be near enough for most points to be in front of the
/// lens.
RefinedPose refine_pose(const Lens& lens, const std::vector<Sighting>& sightings, const Rigid3& start);

}  // namespace svchain::geometry
