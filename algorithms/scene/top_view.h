#pragma once
// The truth that a composite is to come near to. Pure function, any thread.

#include <opencv2/core.hpp>

#include "algorithms/geometry/view.h"
#include "algorithms/scene/world.h"

namespace svchain::scene {

/// What one perfect camera straight above would see of the ground (BGR, 8 bits): no vehicle, no responses, no
/// noise, each pixel the mean over its square.
cv::Mat ideal_top_view(const World& world, const geometry::View& view, double time_s);

}  // namespace svchain::scene
