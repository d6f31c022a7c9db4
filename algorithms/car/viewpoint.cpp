#include "algorithms/car/viewpoint.h"

namespace svchain::car {

Viewpoint seen_from(const bowl::Viewpoint& viewpoint, const Eigen::Vector2i& size_px) {
  const bowl::Perspective perspective(viewpoint, size_px);
  return {perspective.vehicle_from_picture().transpose(), perspective.eye(), perspective.focal_px(),
          (size_px.cast<double>().array() - 1) / 2, size_px};
}

}  // namespace svchain::car
