#pragma once
// From loose triangles to a model: normals where there are none, equal corners made one vertex, triangles
// sorted into parts. Any thread.

#include <array>
#include <span>
#include <vector>

#include "algorithms/car/car_model.h"

namespace svchain::car {

struct LooseTriangle {
  std::array<Vertex, 3> corners;
  uint32_t material = 0;
};

/// Normals from the triangles' own planes: each corner gets the mean, weighted by area, of those that meet
/// there and are turned by less than the crease angle from its own.
void smooth_normals(std::span<LooseTriangle> triangles, float crease_deg);

/// Opaque materials first, each in the order given; those without triangles are left out, as are triangles
/// without area. Triangles are turned to be counter-clockwise seen from where their normals point.
CarModel assemble(const std::vector<Material>& materials, std::span<const LooseTriangle> triangles);

}  // namespace svchain::car
