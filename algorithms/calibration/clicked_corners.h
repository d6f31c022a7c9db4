#pragma once
// Corners that somebody has clicked in the pictures, in a file:
//   {"corners": [{"camera": "front", "chart": "front_left", "corner": 3, "pixel_px": [512.3, 300.1]}, ...]}
// Corners are counted as corners() in charts.h does. A calibration's report is such a file too: its corners'
// further keys are taken without a word, and those of "state" "not_found" are passed over. Pure.

#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration.h"
#include "algorithms/json/fault.h"

namespace svchain::calibration {

/// Every fault: unknown cameras and charts, corners the chart has not, corners clicked twice, pixels outside
/// the image. What needs the charts or the rig's cameras is not checked where there are none, so that the
/// file can be read beside faulty ones.
Result<std::vector<ClickedCorner>> read_clicked_corners(const std::filesystem::path& path,
                                                        const geometry::Rig& rig,
                                                        const std::vector<Chart>& charts);
/// The same from a text, `file` being what messages call it.
Result<std::vector<ClickedCorner>> parse_clicked_corners(const std::string& text, const std::string& file,
                                                         const geometry::Rig& rig,
                                                         const std::vector<Chart>& charts);

}  // namespace svchain::calibration
