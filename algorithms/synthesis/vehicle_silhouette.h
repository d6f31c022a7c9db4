#pragma once
// The vehicle as the composite shows it, where no camera looks: a neutral car from above, drawn to the scale
// of the view into the vehicle's rectangle, so that a toy and a van both fill theirs. Any thread.

#include <opencv2/core/mat.hpp>

#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"

namespace svchain::synthesis {

/// A BGR picture of the whole view, black around the vehicle.
cv::Mat vehicle_silhouette(const geometry::Vehicle& vehicle, const geometry::View& view);

}  // namespace svchain::synthesis
