#pragma once
// Which cameras show a point of the ground. Around the vehicle's rectangle lie four side zones, each of one
// camera, and four corner zones, each shared by two neighbours; a side zone's other neighbour stands by for
// what its own camera does not see. Cameras are front 0, right 1, rear 2, left 3. Plain functions, any
// thread.

#include <Eigen/Core>

#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/blend_shape.h"

namespace svchain::synthesis {

/// True for a ground point (vehicle frame, metres) within the vehicle's rectangle, its edge included.
bool is_under_vehicle(const geometry::Vehicle& vehicle, const Eigen::Vector2d& ground);

/// Two neighbours, clockwise: second = (first + 1) % 4.
struct CameraShares {
  int first = 0;
  int second = 1;
  double share_of_first = 1;  // 0..1 by direction alone, as if both saw the point
};

/// The cameras of a point that is not under the vehicle.
CameraShares camera_shares(const geometry::Vehicle& vehicle, const BlendShape& shape,
                           const Eigen::Vector2d& ground);

/// Weight (0..255) of the first of two cameras, given how far each has faded (0: does not see the point).
/// What a camera loses by fading goes to the other: with s the first's share and f, g the two fades,
///   f (s + (1 - s)(1 - g)) / (f + g - f g),
/// which is s where neither fades, 1 where only the first sees the point, and continuous between. At least
/// one of the fades must be above 0. With a width of 0 it is 0 or 255.
int first_weight(const BlendShape& shape, double share_of_first, double first_fade, double second_fade);

/// The weight that a pixel shows which both cameras are sampled for: a binary curve decides for the camera
/// that has more of it.
int shown_weight(const BlendShape& shape, int first_weight);

}  // namespace svchain::synthesis
