#pragma once
// Pictures as PNG files. Pure.

#include <opencv2/core.hpp>
#include <string>

namespace svchain::program {

/// The bytes of a PNG file.
std::string png_text(const cv::Mat& picture);

}  // namespace svchain::program
