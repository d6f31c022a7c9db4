#pragma once
// Things painted on the ground, as convex patches. Lengths in metres, angles in radians; pure functions.

#include <vector>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

using Outline = std::vector<Eigen::Vector2d>;  // convex, counter-clockwise
using Outlines = std::vector<Outline>;

/// A rectangle about the pose, `length` along its x, `width` along its y.
Outline rectangle(const Pose2& pose, double length_m, double width_m);
Outline disc(const Pose2& pose, double radius_m);
/// A line of the width along the points, its ends reaching half a width beyond them.
Outlines line(const Outline& points_m, double width_m);
/// An arrow about the pose that points along its x.
Outlines arrow(const Pose2& pose, double length_m, double width_m);
/// Bars along x, side by side along y, `width` from the first one's outer edge to the last one's.
Outlines zebra(const Pose2& pose, double length_m, double width_m, int bars);
/// A row of parking bays along the pose's x, beginning there, open at y = 0: `count` bays of length x depth.
Outlines bays(const Pose2& pose, int count, double length_m, double depth_m, double line_m);
/// The board with its white margin.
std::vector<Patch> patches(const Checkerboard& board);

}  // namespace svchain::scene
