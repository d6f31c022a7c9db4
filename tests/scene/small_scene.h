#pragma once
// A scene that is quick to make: a car with four ideal 180-degree cameras on an even grey ground.

#include "algorithms/scene/scene.h"

namespace svchain::testing {

/// `width_px` x 9/16 of it.
scene::Scene small_scene(int width_px = 320);

}  // namespace svchain::testing
