#pragma once
// Surfaces as grids of points, from which the default car is built. Plain values.

#include <functional>
#include <vector>

#include "algorithms/car/model_assembly.h"

namespace svchain::car {

/// Points in rows, each with the same number of columns. Outside is where (next column) x (next row) points.
struct SurfaceGrid {
  int columns = 0, rows = 0;
  std::vector<Eigen::Vector3f> points;  // row by row

  const Eigen::Vector3f& at(int column, int row) const {
    return points[static_cast<size_t>(row) * columns + column];
  }
};

SurfaceGrid make_grid(int columns, int rows,
                      const std::function<Eigen::Vector3f(int column, int row)>& point);

/// Material of the cell whose first corner is (column, row).
using CellMaterial = std::function<uint32_t(int column, int row)>;

/// Collects the triangles of surfaces, each smooth by itself but for creases.
class SurfaceCollector {
 public:
  void add(const SurfaceGrid& grid, const CellMaterial& material, float crease_deg = 40);
  /// And its mirror image on the other side of y = 0; where they meet they are one surface.
  void add_both_sides(const SurfaceGrid& grid, const CellMaterial& material, float crease_deg = 40);

  const std::vector<LooseTriangle>& triangles() const { return triangles_; }

 private:
  void append(const SurfaceGrid& grid, const CellMaterial& material, float side);
  std::vector<LooseTriangle> triangles_;
};

/// A box with round edges and corners: the superellipsoid |x/a|^s + |y/b|^s + |z/c|^s = 1, `sharpness` s.
SurfaceGrid rounded_box(const Eigen::Vector3f& centre, const Eigen::Vector3f& half, float sharpness);

}  // namespace svchain::car
