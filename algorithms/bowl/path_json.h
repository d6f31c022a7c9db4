#pragma once
// Viewpoint paths as files:
//   {"loop": false, "key_frames": [
//     {"time_s": 0, "preset": "chase"},
//     {"time_s": 2.5, "eye_m": [-3, 4, 2], "target_m": [0, 0, 0], "up": [0, 0, 1], "field_of_view_deg": 60}]}
// "up" is upwards and "field_of_view_deg" 60 where they are left out, "loop" false. Any thread.

#include <filesystem>
#include <string>

#include "algorithms/bowl/viewpoint_path.h"

namespace svchain::bowl {

/// A path for this vehicle in this bowl, both free of faults; or every fault in it: unknown keys and presets,
/// times that do not rise, viewpoints that check() refuses, a loop that does not end where it begins.
Result<ViewpointPath> read_path(const std::filesystem::path& path, const geometry::Vehicle& vehicle,
                                const BowlSurface& surface);
/// The same from a text, `file` being what messages call it.
Result<ViewpointPath> parse_path(const std::string& text, const std::string& file,
                                 const geometry::Vehicle& vehicle, const BowlSurface& surface);

}  // namespace svchain::bowl
