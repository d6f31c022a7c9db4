#pragma once
// The painted things of a scene file, read strictly: faults go to the value's list.

#include <vector>

#include "algorithms/json/value.h"
#include "algorithms/scene/scene.h"

namespace svchain::scene {

Colour read_colour(const json::Value& value, Colour usual);
/// {"x_m": 1, "y_m": 2, "yaw_deg": 30}, the yaw 0 where it is left out.
Pose2 read_pose(const json::Value& value);
std::vector<Patch> read_paint(const json::Value& list);

}  // namespace svchain::scene
