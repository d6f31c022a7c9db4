#pragma once
// Models small enough to be known by heart, and files of them.

#include <filesystem>
#include <string>

#include "algorithms/car/model_assembly.h"

namespace svchain::testing {

/// A box with flat sides, standing on the ground.
car::CarModel box_model(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                        const car::Material& material);
/// The triangles of both, opaque parts first.
car::CarModel joined(const car::CarModel& a, const car::CarModel& b);

/// A tetrahedron of four triangles, three of "paint" and one of "window", with its .mtl in the same folder.
void write_obj(const std::filesystem::path& path);
/// A triangle of "paint" and one that blends, twice as large as written and one higher by their node; as
/// .gltf with its buffer inside, or as .glb.
void write_gltf(const std::filesystem::path& path);

std::string file_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace svchain::testing
