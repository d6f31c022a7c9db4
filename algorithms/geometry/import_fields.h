#pragma once
// What imports have in common that read each camera's lens from a file of its own.

#include <filesystem>
#include <functional>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/json/value.h"

namespace svchain::geometry {

/// Width and height, as a list of two.
Eigen::Vector2i image_size(const json::Value& list);
/// Width and height, as two numbers.
Eigen::Vector2i image_size(const json::Value& width, const json::Value& height);

/// The nominal rig with what `read` puts in its cameras, each from the file that names it (see
/// camera_files.h). All faults of all files at once.
Result<Rig> import_camera_files(const std::vector<std::filesystem::path>& files, const Rig& nominal,
                                const std::function<Faults(const std::filesystem::path&, Camera&)>& read);

}  // namespace svchain::geometry
