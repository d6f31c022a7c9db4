#pragma once
// Where two neighbours see the same ground. Plain values and pure functions.

#include <opencv2/core.hpp>
#include <optional>

#include "algorithms/geometry/view.h"
#include "algorithms/registration/perspective.h"

namespace svchain::registration {

/// The other camera of overlap m: the paper counts overlaps by their first camera, clockwise.
inline size_t next_clockwise(size_t camera) {
  return (camera + 1) % 4;
}

/// What a camera shows of the ground: inside its image, away from the lens's rim, and past its own vehicle.
class GroundSight {
 public:
  GroundSight(const GroundCamera& camera, const geometry::Vehicle& vehicle);

  bool sees(const Eigen::Vector2d& ground) const;

 private:
  GroundCamera camera_;
  geometry::Vehicle vehicle_;
  Eigen::Vector2d position_;  // of the camera, from above
  double cos_widest_;
};

/// The smallest part of `view`, at `metres_per_px`, that holds all that both see of it; nothing where they
/// see nothing in common.
std::optional<geometry::View> overlap_of(const GroundSight& a, const GroundSight& b,
                                         const geometry::View& view, double metres_per_px);

/// 255 where both see the ground of a view, else 0 (CV_8U).
cv::Mat seen_by_both(const GroundSight& a, const GroundSight& b, const geometry::View& view);

}  // namespace svchain::registration
