#include "algorithms/synthesis/own_body.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/smoothstep.h"

namespace svchain::synthesis {
namespace {

constexpr double kBody = 0.92;         // of the rectangle, each way
constexpr double kHidingLength = 0.1;  // of the vehicle's length

}  // namespace

double sight_past_body(const geometry::Vehicle& vehicle, const Eigen::Vector2d& camera,
                       const Eigen::Vector2d& ground) {
  const Eigen::Vector2d half(kBody * vehicle.length_m / 2, kBody * vehicle.width_m / 2);
  if ((camera.cwiseAbs().array() <= half.array()).all()) return 1;

  // The line camera + t (ground - camera), clipped to the body's slab in x, then in y (Liang and Barsky).
  const Eigen::Vector2d line = ground - camera;
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (line[axis] == 0) {
      if (std::abs(camera[axis]) > half[axis]) return 1;
      continue;
    }
    const double one = (-half[axis] - camera[axis]) / line[axis],
                 other = (half[axis] - camera[axis]) / line[axis];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  if (enter >= leave) return 1;
  return 1 - smoothstep((leave - enter) * line.norm() / (kHidingLength * vehicle.length_m));
}

}  // namespace svchain::synthesis
