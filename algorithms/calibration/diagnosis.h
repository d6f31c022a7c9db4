#pragma once
// What a calibration that went wrong went wrong by, as a user needs to hear it. Pure.

#include "algorithms/calibration/corner_search.h"

namespace svchain::calibration {

/// Charts that only one camera has seen though another one should have; charts nobody has seen; cameras that
/// share no chart with the others.
std::vector<std::string> missing_views(const Calibration& calibration, const NamedCorners& named);

/// Whether the pictures make more sense with one of them mirrored, or two of them swapped, than what was
/// found in them `as_given`. Looks for charts in all the ways, so it takes about as long as four
/// calibrations.
std::vector<std::string> mistaken_pictures(const CalibrationInput& input, const std::vector<cv::Mat>& greys,
                                           const std::vector<std::vector<Fragment>>& as_given,
                                           const std::vector<ChartPattern>& patterns);

}  // namespace svchain::calibration
