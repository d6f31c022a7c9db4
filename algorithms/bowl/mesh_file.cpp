#include "algorithms/bowl/mesh_file.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include "algorithms/synthesis/stored_block.h"

namespace svchain::bowl {
namespace {

const synthesis::StoredFormat kFormat = {
    {'S', 'V', 'M', 'E', 'S', 'H', '1', '\n'}, 1, "mesh", "surround view"};

std::string text(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

/// Exactly the same numbers: a table is made anew for the least difference.
Faults differences(const std::string& file, const MeshHeader& header, const geometry::Rig& rig,
                   const BowlSurface& surface, const synthesis::BlendShape& shape) {
  Faults faults;
  const auto compare = [&](const std::string& what, double got, double expected) {
    if (got != expected)
      faults.push_back({file, {}, {}, "its " + what + " is " + text(got) + ", expected " + text(expected)});
  };
  if (header.rig_fingerprint != rig_fingerprint(rig))
    faults.push_back({file, {}, {}, "was made for another rig: its vehicle, lenses, images or poses differ"});
  const char* const shapes[] = {"a rectangle", "an ellipse"};
  if (header.floor_shape != static_cast<uint32_t>(surface.shape)) {
    faults.push_back(
        {file, {}, {}, "its floor is not " + std::string(shapes[int(surface.shape)]) + ", as expected"});
  }
  compare("floor_length_m", header.floor_length_m, surface.floor_length_m);
  compare("floor_width_m", header.floor_width_m, surface.floor_width_m);
  compare("rise_m", header.rise_m, surface.rise_m);
  compare("height_m", header.height_m, surface.height_m);
  compare("exponent", header.exponent, surface.exponent);
  compare("blend's width in degrees", header.blend_width_deg, shape.width_deg);
  if (header.blend_curve != static_cast<uint32_t>(shape.curve))
    faults.push_back({file, {}, {}, "blends along another curve than expected"});
  return faults;
}

}  // namespace

void write_mesh_file(const std::filesystem::path& path, const MeshTable& table) {
  synthesis::write_block(path, kFormat, table.bytes());
}

Result<std::vector<std::byte>> read_mesh_file(const std::filesystem::path& path, const geometry::Rig& rig,
                                              const BowlSurface& surface,
                                              const synthesis::BlendShape& shape) {
  auto block = synthesis::read_block(path, kFormat);
  if (!block) return block;
  try {
    Faults faults = differences(path.string(), MeshTable(*block).header(), rig, surface, shape);
    if (!faults.empty()) return tl::unexpected(std::move(faults));
  } catch (const std::invalid_argument& error) {
    return fail(path.string(), error.what());
  }
  return block;
}

}  // namespace svchain::bowl
