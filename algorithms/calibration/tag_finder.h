#pragma once
// Finds AprilTags of the family 36h11 (Olson 2011; Wang and Olson 2016) in a picture, by OpenCV's aruco. A
// tag is upright as OpenCV draws it and `svchain charts` prints it, which is AprilTag's own picture of it
// turned by half a turn. Pure function, any thread.

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace svchain::calibration {

struct FoundTag {
  int id = 0;
  /// Of the black border, in the order of corners() in charts.h: from the tag's own (-x, -y) corner on,
  /// counter-clockwise in the tag's frame. Where the picture shows the tag upright these are its lower left,
  /// lower right, upper right and upper left ones, as one looks at it. In px, x right and y down, the centre
  /// of the first pixel being (0, 0).
  std::array<Eigen::Vector2d, 4> corners_px;
};

/// The tags of a picture (8-bit grey), which has to show the ground from its own side: in a mirrored one
/// there are none. The tags' edges have to be nearly straight, so what a fisheye saw is to be rectified
/// first.
std::vector<FoundTag> find_tags(const cv::Mat& grey);

}  // namespace svchain::calibration
