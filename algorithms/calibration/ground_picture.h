#pragma once
// A camera's picture laid on the ground by a pose that may be some degrees wrong: straight edges are straight
// there and squares nearly square, each of about the same number of pixels, so that one filter finds the
// corners of all. Forward is up, left is left, as in every view. Plain value.

#include <opencv2/core.hpp>

#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"

namespace svchain::calibration {

struct GroundPicture {
  geometry::View view;
  cv::Mat grey;  // CV_32FC1
  cv::Mat seen;  // CV_8UC1, 255 where the camera resolves a square of the wanted size
};

/// Pixels of a square's side in the pictures made here.
inline constexpr double kSidePx = 12;

/// All ground where a square of this side (m) takes so many pixels of the camera's picture (CV_8UC1), across
/// the line of sight and along it. Coarser levels of the picture are used where the ground is near, so that
/// nothing is aliased.
GroundPicture ground_picture(const geometry::Camera& camera, const cv::Mat& grey, double side_m,
                             double least_side_px = 3.5);

}  // namespace svchain::calibration
