#pragma once
// What the readers of single formats give: triangles as the file has them. Internal to this room.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/car/model_assembly.h"
#include "algorithms/json/fault.h"

namespace svchain::car {

/// A corner without a normal has a zero one.
struct LooseModel {
  std::vector<Material> materials;
  std::vector<LooseTriangle> triangles;
};

/// Both throw ModelError for what is wrong with the file; other exceptions come from libraries.
LooseModel read_obj(const std::filesystem::path& path);
LooseModel read_gltf(const std::filesystem::path& path);

struct ModelError {
  std::string message;
};

/// All of a regular file, of which at most `room` bytes are allowed.
std::string read_bytes(const std::filesystem::path& path, uintmax_t room);
/// Throws where the file has one triangle too many.
void check_count(size_t triangles);
void check_finite(const Eigen::Vector3f& position);
/// Whether the name says so.
bool names_glass(const std::string& name);
/// How opaque a material is that only its name or its mode calls translucent.
inline constexpr float kPaneOpacity = 0.62f;

}  // namespace svchain::car
