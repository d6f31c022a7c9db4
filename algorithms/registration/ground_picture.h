#pragma once
// Frames as seen from straight above: lens correction and perspective in one map, as the paper warps them.
// Where the ground's pixels are larger than the image's, the image is read from a coarser level of its
// pyramid. Plain values and pure functions.

#include <opencv2/core.hpp>
#include <vector>

#include "algorithms/geometry/view.h"
#include "algorithms/registration/perspective.h"

namespace svchain::registration {

/// A frame in grey (CV_32F, 0..255), then halved again and again.
using Pyramid = std::vector<cv::Mat>;

/// Of a frame with 8 bits, grey or BGR.
Pyramid pyramid(const cv::Mat& frame);

/// The ground of `view`, grey (CV_32F); 0 where the camera's image does not show it.
cv::Mat ground_picture(const Pyramid& frame, const GroundCamera& camera, const geometry::View& view);

}  // namespace svchain::registration
