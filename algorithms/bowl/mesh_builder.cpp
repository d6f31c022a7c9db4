#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "algorithms/bowl/mesh_refinement.h"
#include "algorithms/bowl/mesh_table.h"

namespace svchain::bowl {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument("mesh table: " + message);
}

void check_input(const geometry::Rig& rig, const BowlSurface& surface, const synthesis::BlendShape& shape,
                 double tolerance_px) {
  if (rig.cameras.size() != 4) refuse("expected four cameras, got " + std::to_string(rig.cameras.size()));
  for (const auto& camera : rig.cameras)
    if (!camera.lens || camera.image_size_px.minCoeff() < 2 || camera.image_size_px.maxCoeff() > 0xFFFF)
      refuse("camera " + camera.name + " has no lens, or an image that is not 2 to 65535 px wide and high");
  std::string faults;
  for (const Fault& fault : check(surface, rig.vehicle))
    faults += (faults.empty() ? "" : "; ") + fault.pointer.substr(1) + ": " + fault.message;
  if (!faults.empty()) refuse(faults);
  if (!(shape.width_deg >= 0 && shape.width_deg <= 90))
    refuse("the blend is " + std::to_string(shape.width_deg) + " degrees wide, expected 0 to 90");
  if (!(tolerance_px >= 0.05 && tolerance_px <= 100))
    refuse("the tolerance is " + std::to_string(tolerance_px) + " px, expected 0.05 to 100");
}

/// Vertices and indices of one batch while it grows.
struct GrowingBatch {
  uint32_t first = 0, second = 0;  // cameras
  std::vector<MeshVertex> vertices;
  std::vector<uint32_t> indices;  // of its own vertices
  std::unordered_map<int, uint32_t> vertex_of_place;
};

class Batches {
 public:
  Batches(const MeshRefinement& refinement, const geometry::Rig& rig, const BowlSurface& surface)
      : refinement_(refinement), rig_(rig), surface_(surface) {
    for (uint32_t i = 0; i < 4; ++i) {
      all_[i].first = all_[4 + i].first = all_[4 + i].second = i;
      all_[i].second = (i + 1) % 4;
    }
  }

  void add(const ShownTriangle& triangle) {
    GrowingBatch& batch = all_[triangle.alone < 0 ? triangle.pair : 4 + triangle.alone];
    for (const int place : triangle.corner) {
      const auto next = static_cast<uint32_t>(batch.vertices.size());
      const auto [found, fresh] = batch.vertex_of_place.try_emplace(place, next);
      if (fresh) batch.vertices.push_back(vertex(triangle, place));
      batch.indices.push_back(found->second);
    }
  }

  size_t write(MeshHeader header, std::span<std::byte> memory) const;

 private:
  MeshVertex vertex(const ShownTriangle& triangle, int place) const {
    const BisectedMesh& mesh = refinement_.mesh();
    const PairSight& sight = refinement_.sight(triangle.pair, place);
    const double height = surface_.height_at(mesh.ground(place)) / mesh.metres_per_unit();
    MeshVertex vertex = {};
    vertex.position = {static_cast<int16_t>(mesh.places()[place].x()),
                       static_cast<int16_t>(mesh.places()[place].y()),
                       static_cast<int16_t>(std::min(32767L, std::lround(height)))};
    vertex.first_weight =
        static_cast<uint8_t>(triangle.alone < 0 ? refinement_.first_weight(triangle.pair, place) : 255);
    for (int i = 0; i < 2; ++i) {
      const int which = triangle.alone < 0 ? i : triangle.alone != triangle.pair;
      const Eigen::Vector2i& size = rig_.cameras[(triangle.pair + which) % 4].image_size_px;
      for (int axis = 0; axis < 2; ++axis) {
        const double part = ((*sight.pixel[which])[axis] + 0.5) / size[axis];
        vertex.texture[2 * i + axis] = static_cast<uint16_t>(std::lround(65535 * part));
      }
    }
    return vertex;
  }

  const MeshRefinement& refinement_;
  const geometry::Rig& rig_;
  const BowlSurface& surface_;
  std::array<GrowingBatch, kMostBatches> all_;
};

size_t Batches::write(MeshHeader header, std::span<std::byte> memory) const {
  std::vector<MeshVertex> vertices;
  std::vector<uint16_t> indices;
  for (const GrowingBatch& batch : all_) {
    if (batch.indices.empty()) continue;
    const auto first_vertex = static_cast<uint32_t>(vertices.size());
    if (first_vertex + batch.vertices.size() > kMostVertices)
      refuse("more than " + std::to_string(kMostVertices) + " vertices, expected a larger tolerance");
    header.batches[header.batch_count] = {batch.first,
                                          batch.second,
                                          first_vertex,
                                          static_cast<uint32_t>(batch.vertices.size()),
                                          static_cast<uint32_t>(indices.size()),
                                          static_cast<uint32_t>(batch.indices.size())};
    for (MeshVertex vertex : batch.vertices) {
      vertex.batch = static_cast<uint8_t>(header.batch_count);
      vertices.push_back(vertex);
    }
    for (const uint32_t index : batch.indices) indices.push_back(static_cast<uint16_t>(first_vertex + index));
    ++header.batch_count;
  }
  header.vertex_count = static_cast<uint32_t>(vertices.size());
  header.index_count = static_cast<uint32_t>(indices.size());
  header.vertices_at = sizeof(MeshHeader);
  header.indices_at = static_cast<uint32_t>(header.vertices_at + std::span(vertices).size_bytes());
  header.bytes = static_cast<uint32_t>(header.indices_at + std::span(indices).size_bytes());
  if (header.bytes > memory.size()) {
    refuse("needs " + std::to_string(header.bytes) + " bytes, but the memory has only " +
           std::to_string(memory.size()));
  }
  std::memcpy(memory.data(), &header, sizeof(header));
  std::memcpy(memory.data() + header.vertices_at, vertices.data(), std::span(vertices).size_bytes());
  std::memcpy(memory.data() + header.indices_at, indices.data(), std::span(indices).size_bytes());
  return header.bytes;
}

MeshHeader header_for(const geometry::Rig& rig, const BowlSurface& surface,
                      const synthesis::BlendShape& shape, double tolerance_px) {
  MeshHeader header = {};
  header.magic = kMeshMagic;
  header.version = kMeshVersion;
  for (int i = 0; i < 4; ++i)
    header.image_size_px[i] = {rig.cameras[i].image_size_px.x(), rig.cameras[i].image_size_px.y()};
  header.floor_shape = static_cast<uint32_t>(surface.shape);
  header.blend_curve = static_cast<uint32_t>(shape.curve);
  header.rig_fingerprint = rig_fingerprint(rig);
  header.floor_length_m = surface.floor_length_m;
  header.floor_width_m = surface.floor_width_m;
  header.rise_m = surface.rise_m;
  header.height_m = surface.height_m;
  header.exponent = surface.exponent;
  header.blend_width_deg = shape.width_deg;
  header.tolerance_px = tolerance_px;
  return header;
}

}  // namespace

size_t build_mesh_table(const geometry::Rig& rig, const BowlSurface& surface,
                        const synthesis::BlendShape& shape, double tolerance_px,
                        std::span<std::byte> memory) {
  check_input(rig, surface, shape, tolerance_px);
  const MeshRefinement refinement(rig, surface, shape, tolerance_px);
  Batches batches(refinement, rig, surface);
  for (const ShownTriangle& triangle : refinement.shown()) batches.add(triangle);
  MeshHeader header = header_for(rig, surface, shape, tolerance_px);
  header.metres_per_unit = refinement.mesh().metres_per_unit();
  return batches.write(header, memory);
}

}  // namespace svchain::bowl
