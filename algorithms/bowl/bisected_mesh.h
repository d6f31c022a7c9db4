#pragma once
// Triangles over the bowl from above, from the vehicle's rectangle to the rim, that can be made smaller where
// need be and stay conforming: every edge inside is shared, whole, by exactly two of them. Newest-vertex
// bisection (Mitchell, "Adaptive refinement for elliptic problems"): a triangle is cut from its newest vertex
// to the middle of the opposite edge, its neighbour across that edge with it, after that neighbour's own turn
// if it would be cut elsewhere. The start is rings of quadrangles between spokes; each diagonal is the first
// edge to be cut of both its triangles, so that turns end. Corners lie on a lattice of whole numbers, so
// that equal places are equal exactly. No triangle crosses the vehicle's axes. One thread.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "algorithms/bowl/bowl_surface.h"
#include "algorithms/geometry/rig.h"

namespace svchain::bowl {

class BisectedMesh {
 public:
  struct Triangle {
    std::array<int, 3> corner;  // counter-clockwise from above, the newest first
    bool cut = false;           // into two others
  };

  /// Vehicle and surface must be free of faults.
  BisectedMesh(const geometry::Vehicle& vehicle, const BowlSurface& surface);

  /// The lattice: fine enough that 16 bits reach from the origin to everywhere on the bowl.
  double metres_per_unit() const { return metres_per_unit_; }
  const std::vector<Eigen::Vector2i>& places() const { return places_; }
  /// Those that are cut too.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Eigen::Vector2d ground(int place) const { return places_[place].cast<double>() * metres_per_unit_; }

  /// Longest edge, from above.
  double size_m(const Triangle& triangle) const;
  /// Cuts a triangle, and of its neighbours what must be cut for it. New ones are appended.
  void cut(int triangle);

 private:
  int add_place(const Eigen::Vector2d& ground, bool on_rim);
  void add_triangle(const std::array<int, 3>& corner);
  void add_quadrangle(int a, int b, int c, int d);
  int neighbour(int triangle) const;
  int middle_of(int a, int b, bool alone);
  void halve(int triangle, int middle);

  BowlSurface surface_;
  double metres_per_unit_;
  std::vector<Eigen::Vector2i> places_;
  std::vector<bool> on_rim_;
  std::vector<Triangle> triangles_;
  std::unordered_map<uint64_t, std::array<int, 2>> triangles_of_edge_;  // -1: none
};

}  // namespace svchain::bowl
