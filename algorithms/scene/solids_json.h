#pragma once
// The standing things of a scene file, read strictly: faults go to the values' list.

#include <vector>

#include "algorithms/json/value.h"
#include "algorithms/scene/scene.h"

namespace svchain::scene {

std::vector<Box> read_boxes(const json::Value& list);
std::vector<Post> read_posts(const json::Value& list);

}  // namespace svchain::scene
