#pragma once
// The strongest corners of a picture (Harris and Stephens, 1988), kept apart from one another. Pure.

#include <opencv2/core.hpp>
#include <vector>

namespace svchain::registration {

/// At most `most` corners of a grey picture (CV_32F), strongest first, where `where` (CV_8U) is not 0, each
/// the strongest within `spacing_px`.
std::vector<cv::Point> strongest_corners(const cv::Mat& picture, const cv::Mat& where, size_t most,
                                         int spacing_px);

}  // namespace svchain::registration
