#pragma once
// The pictures of a calibration in grey, checked against the rig. Pure.

#include "algorithms/calibration/calibration.h"

namespace svchain::calibration {

/// One of each camera; empty ones where all corners are clicked and no pictures given. Throws
/// std::invalid_argument where they are not one of each camera, 8 bits, of its size.
std::vector<cv::Mat> grey_pictures(const CalibrationInput& input);

}  // namespace svchain::calibration
