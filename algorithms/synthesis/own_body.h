#pragma once
// The vehicle in its own cameras' way: a camera on one side does not see the ground on the other. Seen from
// above, the body that hides is the vehicle's rectangle a little smaller (0.92), because its corners are
// round and cameras sit in its skin.

#include <Eigen/Core>

#include "algorithms/geometry/rig.h"

namespace svchain::synthesis {

/// 1 where the line of sight from a camera to a ground point (vehicle frame, metres, from above) misses the
/// body, falling smoothly to 0 where a tenth of the vehicle's length of it runs through. A camera above
/// the body looks over it: 1.
double sight_past_body(const geometry::Vehicle& vehicle, const Eigen::Vector2d& camera,
                       const Eigen::Vector2d& ground);

}  // namespace svchain::synthesis
