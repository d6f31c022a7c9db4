#pragma once
// A mesh table with the memory it is in. For tests.

#include <vector>

#include "algorithms/bowl/mesh_table.h"
#include "tests/synthesis/four_cameras.h"

namespace svchain::testing {

class OwnedMesh {
 public:
  OwnedMesh(const geometry::Rig& rig, const bowl::BowlSurface& surface,
            const synthesis::BlendShape& shape = {}, double tolerance_px = bowl::kDefaultTolerancePx)
      : memory_(bowl::mesh_table_capacity()) {
    memory_.resize(bowl::build_mesh_table(rig, surface, shape, tolerance_px, memory_));
  }
  bowl::MeshTable table() const { return bowl::MeshTable(std::span<const std::byte>(memory_)); }
  const std::vector<std::byte>& memory() const { return memory_; }

 private:
  std::vector<std::byte> memory_;
};

}  // namespace svchain::testing
