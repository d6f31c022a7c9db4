#pragma once
// A geometric LUT on disk, as stored_block.h stores it: what a car keeps from one power-up to the next.
// Functions may be called from any thread.

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/geometry/view.h"
#include "algorithms/json/fault.h"

namespace svchain::synthesis {

/// Writes a LUT, the file being there whole or not at all: it gets its name when it is complete. Throws
/// std::runtime_error that names the path.
void write_lut_file(const std::filesystem::path& path, std::span<const std::byte> lut);

/// The LUT of a file, which must be one for this view and the image sizes of this rig. Faults name the file:
/// it cannot be read, is no LUT, is of another version, cut short or damaged; or all that differs from view
/// and rig.
Result<std::vector<std::byte>> read_lut_file(const std::filesystem::path& path, const geometry::Rig& rig,
                                             const geometry::View& view);

}  // namespace svchain::synthesis
