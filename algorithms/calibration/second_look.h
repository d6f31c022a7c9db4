#pragma once
// A second look at the pictures, with everything roughly known: every corner of every chart is looked for
// where it has to be, so bends, single corners and those the first search passed over are found as well.
// Pure.

#include <opencv2/core.hpp>

#include "algorithms/calibration/seen_corners.h"
#include "algorithms/geometry/rig.h"

namespace svchain::calibration {

/// Where a camera has to see a corner, and its edges in px.
struct ExpectedCorner {
  Eigen::Vector2d pixel;
  Eigen::Vector2d along_x_px, along_y_px;  // as far as the corner reaches

  double least_edge_px() const { return std::min(along_x_px.norm(), along_y_px.norm()); }
  bool can_be_found() const { return least_edge_px() > 2.5; }
};
/// Nothing where the camera does not see it.
std::optional<ExpectedCorner> expect(const geometry::Camera& camera, const ChartCorner& corner,
                                     const geometry::Pose2& vehicle_from_chart);

/// Null where there is no such corner.
const SeenCorner* find(const std::vector<SeenCorner>& corners, size_t camera, size_t chart, int corner);

/// The corners one camera sees: those in `known`, and others that are within `reach_px` of where they are
/// expected.
std::vector<SeenCorner> look_again(size_t camera_index, const geometry::Camera& camera, const cv::Mat& grey,
                                   const std::vector<ChartPattern>& patterns,
                                   const std::vector<UnknownChart>& charts, const std::vector<bool>& placed,
                                   const std::vector<SeenCorner>& known, double reach_px);

}  // namespace svchain::calibration
