#pragma once
// A car as triangles, in the vehicle's frame: x forward, y left, z up, metres, origin on the ground below the
// middle. Plain values; any thread may read one.

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/geometry/rig.h"

namespace svchain::car {

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  // unit, outwards
};

/// What lighting.h makes of it. Colours are linear R, G, B, 0..1.
struct Material {
  std::string name;  // "paint", "glass", "tyre", "rim", "light_front", "light_rear", "trim", ...
  Eigen::Vector3f base_colour = {0.5f, 0.5f, 0.5f};
  float opacity = 1;   // 0 lets everything through; reflections are added to it
  float gloss = 0;     // 0 scatters, 1 mirrors
  float metallic = 0;  // 1: reflections have the base colour and nothing is scattered

  bool opaque() const { return opacity >= 1; }
  bool operator==(const Material&) const = default;
};

/// A contiguous range of `indices`, whole triangles.
struct Part {
  Material material;
  uint32_t first_index = 0;
  uint32_t index_count = 0;
};

/// Three indices a triangle, counter-clockwise seen from outside. Parts follow one another without gaps,
/// opaque ones first.
struct CarModel {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  std::vector<Part> parts;

  size_t triangle_count() const { return indices.size() / 3; }
};

/// Empty for a model without vertices.
Eigen::AlignedBox3f bounding_box(const CarModel& model);
/// Of one part's triangles.
Eigen::AlignedBox3f bounding_box(const CarModel& model, const Part& part);

/// The model as long as the vehicle, above the middle of its rectangle, its lowest point on the ground. One
/// scale for all axes, unless the width then differs from the vehicle's by more than 15 %: then y has a scale
/// of its own. `model` has an extent along x and y.
CarModel fit_to(const CarModel& model, const geometry::Vehicle& vehicle);

}  // namespace svchain::car
