#pragma once
// A calibration to look at. Pure.

#include <opencv2/core.hpp>

#include "algorithms/calibration/calibration.h"
#include "algorithms/geometry/view.h"

namespace svchain::calibration {

/// A camera's picture (BGR or grey, 8 bits) with its corners in it: fitted ones as green circles, held out
/// ones as blue squares, rejected ones as red crosses with a line to where they should be, and where one
/// should be that was not found a yellow plus. The legend counts them. Marks grow with the picture.
cv::Mat corners_picture(const cv::Mat& picture, size_t camera, const Calibration& calibration);

/// The view of the vehicle and every chart that has a place, its longer side 1600 px.
geometry::View charts_view(const geometry::Vehicle& vehicle, const std::vector<Chart>& charts);

/// The pictures as the calibrated rig lays them on the ground, in that view.
cv::Mat stitched_picture(const std::vector<cv::Mat>& pictures, const Calibration& calibration);

}  // namespace svchain::calibration
