#include "algorithms/bowl/mesh_table.h"

#include <stdexcept>
#include <string>

#include "algorithms/synthesis/stored_block.h"

namespace svchain::bowl {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("mesh table: " + message);
}

/// 16 bits of it reach 32 km.
bool is_unit_of_length(double metres) {
  return metres > 0 && metres <= 1;
}

}  // namespace

uint64_t rig_fingerprint(const geometry::Rig& rig) {
  geometry::Rig bare = rig;
  bare.calibration.clear();
  const std::string text = geometry::rig_text(bare);
  return synthesis::fnv1a(std::as_bytes(std::span(text)));
}

size_t mesh_table_capacity() {
  // A triangulation without holes has less than two triangles a vertex.
  return sizeof(MeshHeader) + kMostVertices * (sizeof(MeshVertex) + 2 * 3 * sizeof(uint16_t));
}

MeshTable::MeshTable(std::span<const std::byte> memory) : memory_(memory) {
  require(reinterpret_cast<uintptr_t>(memory.data()) % alignof(MeshHeader) == 0, "the memory is not aligned");
  require(memory.size() >= sizeof(MeshHeader), "shorter than its header");
  const MeshHeader& h = header();
  require(h.magic == kMeshMagic, "the memory holds none");
  require(h.version == kMeshVersion,
          "version " + std::to_string(h.version) + ", expected " + std::to_string(kMeshVersion));
  require(h.bytes >= sizeof(MeshHeader) && h.bytes <= memory.size(),
          std::to_string(h.bytes) + " bytes long, but the memory has only " + std::to_string(memory.size()));
  memory_ = memory.first(h.bytes);
  check_layout();
  check_batches();
}

void MeshTable::check_layout() const {
  const MeshHeader& h = header();
  const auto within = [&](size_t offset, size_t count, size_t size, size_t alignment) {
    return offset >= sizeof(MeshHeader) && offset <= h.bytes && offset % alignment == 0 &&
           count <= (h.bytes - offset) / size;
  };
  require(h.vertex_count <= kMostVertices &&
              within(h.vertices_at, h.vertex_count, sizeof(MeshVertex), alignof(MeshVertex)),
          "the vertices leave it");
  require(h.index_count % 3 == 0 && within(h.indices_at, h.index_count, sizeof(uint16_t), alignof(uint16_t)),
          "the triangles leave it");
  require(is_unit_of_length(h.metres_per_unit), "its unit of length is not more than 0 and at most 1 m");
  for (const auto& size : h.image_size_px)
    require(size[0] > 0 && size[1] > 0 && size[0] <= 0xFFFF && size[1] <= 0xFFFF,
            "an image that is not 1 to 65535 px wide and high");
}

/// Batches take vertices and indices in their order, and stay with their own.
void MeshTable::check_batches() const {
  const MeshHeader& h = header();
  require(h.batch_count <= kMostBatches, "too many batches");
  uint64_t next_vertex = 0, next_index = 0;
  for (uint32_t b = 0; b < h.batch_count; ++b) {
    const MeshBatch& batch = h.batches[b];
    const std::string name = "batch " + std::to_string(b);
    require(batch.first < 4 && (batch.second == batch.first || batch.second == (batch.first + 1) % 4),
            name + " has cameras that are no clockwise neighbours");
    require(batch.first_vertex == next_vertex && batch.first_index == next_index &&
                batch.index_count % 3 == 0 && next_vertex + batch.vertex_count <= h.vertex_count &&
                next_index + batch.index_count <= h.index_count,
            name + " is not where it has to be");
    next_vertex += batch.vertex_count;
    next_index += batch.index_count;
    for (const MeshVertex& vertex : vertices().subspan(batch.first_vertex, batch.vertex_count))
      require(vertex.batch == b, name + " has a vertex of another one");
    for (const uint16_t index : indices(batch))
      require(index >= batch.first_vertex && index < next_vertex, name + " has a triangle that leaves it");
  }
  require(next_vertex == h.vertex_count && next_index == h.index_count, "vertices or triangles of no batch");
}

BowlSurface MeshTable::surface() const {
  const MeshHeader& h = header();
  return {static_cast<FloorShape>(h.floor_shape),
          h.floor_length_m,
          h.floor_width_m,
          h.rise_m,
          h.height_m,
          h.exponent};
}

}  // namespace svchain::bowl
