#pragma once
// The paper's mesh table with its blend table: the bowl as triangles, with the place of every corner in the
// images of the two cameras that show it best, and how these two blend. One flat, position-independent block
// of bytes, because it travels between cores in a pool buffer and into files. Shape: a header with a list of
// batches, the vertices, the indices of the triangles (three each, counter-clockwise seen from inside).
// A batch is drawn with one pair of clockwise neighbours, or with one camera alone (`second` is `first`, and
// all weights are 255). Its vertices and indices lie one after the other. Where two batches meet, vertices
// are there twice with equal positions, so that no crack shows. What lies under the vehicle is left out, and
// so is what no camera sees. Every vertex of a batch is seen by all its cameras: no texture comes from behind
// a lens.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/synthesis/blend_shape.h"

namespace svchain::bowl {

inline constexpr uint32_t kMeshMagic = 0x4853454d;  // "MESH"
inline constexpr uint32_t kMeshVersion = 1;
inline constexpr uint32_t kMostVertices = 65535;  // what 16-bit indices reach
inline constexpr uint32_t kMostBatches = 8;       // four pairs of neighbours, four cameras
inline constexpr double kDefaultTolerancePx = 0.75;

struct MeshVertex {
  std::array<int16_t, 3> position;  // in the header's metres_per_unit
  uint8_t first_weight;             // share of the batch's first camera in 255ths
  uint8_t batch;
  /// u, v in the first camera's image, then in the second's: 0 is the image's left or upper edge, 65535 the
  /// other, as texture coordinates that a GPU takes for 0 to 1. Pixel i's centre is at (i + 0.5) / size.
  std::array<uint16_t, 4> texture;
};
static_assert(sizeof(MeshVertex) == 16 && std::is_trivially_copyable_v<MeshVertex>);

struct MeshBatch {
  uint32_t first, second;  // cameras
  uint32_t first_vertex, vertex_count;
  uint32_t first_index, index_count;
};
static_assert(sizeof(MeshBatch) == 24);

struct MeshHeader {
  uint32_t magic;
  uint32_t version;
  uint32_t bytes;  // of the whole table
  uint32_t batch_count;
  uint32_t vertex_count;
  uint32_t index_count;              // three a triangle
  uint32_t vertices_at, indices_at;  // offsets in bytes from the table's start
  std::array<MeshBatch, kMostBatches> batches;
  std::array<std::array<int32_t, 2>, 4> image_size_px;
  uint32_t floor_shape, blend_curve;  // as the enumerations say
  uint64_t rig_fingerprint;
  double metres_per_unit;
  double floor_length_m, floor_width_m, rise_m, height_m, exponent;
  double blend_width_deg;
  double tolerance_px;
};
static_assert(sizeof(MeshHeader) == 336 && std::is_trivially_copyable_v<MeshHeader>);

/// Of all that a mesh table depends on in a rig: vehicle, lenses, images and poses, but not what its
/// calibration says of itself.
uint64_t rig_fingerprint(const geometry::Rig& rig);

/// Bytes that are enough for any mesh table.
size_t mesh_table_capacity();

/// Writes the mesh table of a rig of four cameras into memory (aligned to 8 bytes) and returns the bytes
/// used. Triangles are made smaller until texture coordinates between their corners, interpolated, are at
/// most `tolerance_px` of the camera's image off, and weights a few 255ths. Throws std::invalid_argument,
/// naming the culprit, where there are not four cameras, surface, blend or tolerance are no good, the memory
/// does not suffice or the tolerance asks for more than kMostVertices.
size_t build_mesh_table(const geometry::Rig& rig, const BowlSurface& surface,
                        const synthesis::BlendShape& shape, double tolerance_px, std::span<std::byte> memory);

/// Reads a mesh table in place. Borrows the memory; any number of threads.
class MeshTable {
 public:
  /// Throws std::invalid_argument for memory that holds no mesh table of this version or a truncated one, and
  /// where an offset, a batch or an index leaves its bounds.
  explicit MeshTable(std::span<const std::byte> memory);

  const MeshHeader& header() const { return *at<MeshHeader>(0); }
  std::span<const std::byte> bytes() const { return memory_; }
  std::span<const MeshVertex> vertices() const {
    return {at<MeshVertex>(header().vertices_at), header().vertex_count};
  }
  std::span<const uint16_t> indices() const {
    return {at<uint16_t>(header().indices_at), header().index_count};
  }
  std::span<const MeshBatch> batches() const {
    return std::span(header().batches).first(header().batch_count);
  }
  std::span<const uint16_t> indices(const MeshBatch& batch) const {
    return indices().subspan(batch.first_index, batch.index_count);
  }
  uint32_t triangle_count() const { return header().index_count / 3; }

  /// The bowl it was made of.
  BowlSurface surface() const;
  /// Vehicle frame, metres.
  Eigen::Vector3d position(const MeshVertex& vertex) const {
    return header().metres_per_unit *
           Eigen::Vector3d(vertex.position[0], vertex.position[1], vertex.position[2]);
  }
  /// In the image of the batch's first camera (0) or second (1).
  Eigen::Vector2d pixel(const MeshVertex& vertex, int which) const {
    const MeshBatch& batch = header().batches[vertex.batch];
    const auto& size = header().image_size_px[which == 0 ? batch.first : batch.second];
    return {vertex.texture[2 * which] / 65535.0 * size[0] - 0.5,
            vertex.texture[2 * which + 1] / 65535.0 * size[1] - 0.5};
  }

 private:
  template <class T>
  const T* at(size_t offset) const {
    return reinterpret_cast<const T*>(memory_.data() + offset);
  }
  void check_layout() const;
  void check_batches() const;

  std::span<const std::byte> memory_;
};

}  // namespace svchain::bowl
