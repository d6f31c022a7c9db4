#pragma once
// The four cameras' pictures to calibrate with, from a folder as a run takes it for its input: stills, or the
// first of numbered frames or of videos.

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/json/fault.h"

namespace svchain::program {

/// Front, right, rear, left, BGR. Every fault, pictures that are not of the cameras' sizes among them; of
/// those nothing is said where the rig has no cameras. Throws std::runtime_error where a video says one thing
/// and holds another.
Result<std::vector<cv::Mat>> read_four_pictures(const std::filesystem::path& folder,
                                                const geometry::Rig& rig);

}  // namespace svchain::program
