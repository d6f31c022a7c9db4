#pragma once
// A mesh table on disk, as synthesis/stored_block.h stores it. Functions may be called from any thread.

#include <filesystem>
#include <vector>

#include "algorithms/bowl/mesh_table.h"
#include "algorithms/json/fault.h"

namespace svchain::bowl {

/// The file is there whole or not at all. Throws std::runtime_error that names the path.
void write_mesh_file(const std::filesystem::path& path, const MeshTable& table);

/// The mesh table of a file, which must be that of this rig, surface and blend. Faults name the file: it
/// cannot be read, is no mesh table, is of another version, cut short or damaged; or all that differs.
Result<std::vector<std::byte>> read_mesh_file(const std::filesystem::path& path, const geometry::Rig& rig,
                                              const BowlSurface& surface, const synthesis::BlendShape& shape);

}  // namespace svchain::bowl
