#include "algorithms/car/surface_grid.h"

#include <cmath>
#include <numbers>

namespace svchain::car {

SurfaceGrid make_grid(int columns, int rows, const std::function<Eigen::Vector3f(int, int)>& point) {
  SurfaceGrid grid{columns, rows, {}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) grid.points.push_back(point(column, row));
  return grid;
}

void SurfaceCollector::append(const SurfaceGrid& grid, const CellMaterial& material, float side) {
  const auto add_triangle = [&](uint32_t m, Eigen::Vector3f a, Eigen::Vector3f b, Eigen::Vector3f c) {
    for (Eigen::Vector3f* p : {&a, &b, &c}) p->y() *= side;
    if ((b - a).cross(c - a).norm() < 1e-9f) return;
    const Eigen::Vector3f none = Eigen::Vector3f::Zero();
    if (side < 0) std::swap(b, c);
    triangles_.push_back({{Vertex{a, none}, Vertex{b, none}, Vertex{c, none}}, m});
  };
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const uint32_t m = material(column, row);
      const Eigen::Vector3f &a = grid.at(column, row), &b = grid.at(column + 1, row);
      const Eigen::Vector3f &c = grid.at(column, row + 1), &d = grid.at(column + 1, row + 1);
      add_triangle(m, a, b, d);
      add_triangle(m, a, d, c);
    }
}

void SurfaceCollector::add(const SurfaceGrid& grid, const CellMaterial& material, float crease_deg) {
  const size_t before = triangles_.size();
  append(grid, material, 1);
  smooth_normals(std::span(triangles_).subspan(before), crease_deg);
}

void SurfaceCollector::add_both_sides(const SurfaceGrid& grid, const CellMaterial& material,
                                      float crease_deg) {
  const size_t before = triangles_.size();
  append(grid, material, 1);
  append(grid, material, -1);
  smooth_normals(std::span(triangles_).subspan(before), crease_deg);
}

SurfaceGrid rounded_box(const Eigen::Vector3f& centre, const Eigen::Vector3f& half, float sharpness) {
  constexpr int kAround = 12, kUp = 6;
  constexpr float kPi = std::numbers::pi_v<float>;
  const auto bulge = [&](float v) {
    return std::abs(v) < 1e-6f ? 0.0f : std::copysign(std::pow(std::abs(v), 2 / sharpness), v);
  };
  return make_grid(kAround + 1, kUp + 1, [&](int column, int row) -> Eigen::Vector3f {
    const float around = 2 * kPi * static_cast<float>(column % kAround) / kAround;
    const float up = kPi * (static_cast<float>(row) / kUp - 0.5f);
    const float ring = bulge(std::cos(up));
    return centre + half.cwiseProduct(Eigen::Vector3f(ring * bulge(std::cos(around)),
                                                      ring * bulge(std::sin(around)), bulge(std::sin(up))));
  });
}

}  // namespace svchain::car
