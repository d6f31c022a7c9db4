#pragma once
// Which triangles of a mesh table lie over a ground point, seen from above. For tests.

#include <cmath>
#include <vector>

#include "algorithms/bowl/mesh_table.h"

namespace svchain::testing {

class TriangleCover {
 public:
  explicit TriangleCover(const bowl::MeshTable& table) : unit_(table.header().metres_per_unit) {
    const auto indices = table.indices();
    for (size_t t = 0; t < indices.size(); t += 3) {
      Triangle triangle;
      for (size_t i = 0; i < 3; ++i) {
        const auto& p = table.vertices()[indices[t + i]].position;
        triangle.corner[i] = Eigen::Vector2d(p[0], p[1]);
      }
      triangle.low = triangle.corner[0].cwiseMin(triangle.corner[1]).cwiseMin(triangle.corner[2]);
      triangle.high = triangle.corner[0].cwiseMax(triangle.corner[1]).cwiseMax(triangle.corner[2]);
      triangles_.push_back(triangle);
    }
  }

  /// Triangles that the point (metres) lies inside of.
  int count(const Eigen::Vector2d& ground) const {
    const Eigen::Vector2d p = ground / unit_;
    int inside = 0;
    for (const Triangle& t : triangles_) {
      if ((p.array() < t.low.array()).any() || (p.array() > t.high.array()).any()) continue;
      bool in = true;
      for (size_t i = 0; i < 3; ++i) in = in && left_of(t.corner[i], t.corner[(i + 1) % 3], p) > 0;
      inside += in;
    }
    return inside;
  }

  /// Sum of the triangles' areas from above, m^2; negative ones count as such.
  double area_m2() const {
    double units = 0;
    for (const Triangle& t : triangles_) units += left_of(t.corner[0], t.corner[1], t.corner[2]) / 2;
    return units * unit_ * unit_;
  }

 private:
  struct Triangle {
    std::array<Eigen::Vector2d, 3> corner;
    Eigen::Vector2d low, high;
  };
  static double left_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    const Eigen::Vector2d along = b - a, to = p - a;
    return along.x() * to.y() - along.y() * to.x();
  }

  double unit_;
  std::vector<Triangle> triangles_;
};

}  // namespace svchain::testing
