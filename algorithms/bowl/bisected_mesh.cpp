#include "algorithms/bowl/bisected_mesh.h"

#include <algorithm>
#include <cmath>

namespace svchain::bowl {
namespace {

constexpr int kLargestUnit = 32767;
constexpr std::array<double, 6> kRings = {0, 0.07, 0.2, 0.42, 0.7, 1};  // of the way to the rim
constexpr int kAcrossEnd = 2, kAlongSide = 3;  // quadrangles along half of the vehicle's end and side

uint64_t edge_key(int a, int b) {
  return uint64_t(std::min(a, b)) << 32 | uint64_t(std::max(a, b));
}

/// Away from 0, so that what lies on the vehicle's edge does not come to lie under the vehicle.
int outwards(double units) {
  return static_cast<int>(units < 0 ? std::floor(units) : std::ceil(units));
}

/// Points of the vehicle's rectangle, counter-clockwise from straight ahead, its corners among them.
std::vector<Eigen::Vector2d> outline(const geometry::Vehicle& vehicle) {
  const double x = vehicle.length_m / 2, y = vehicle.width_m / 2;
  std::vector<Eigen::Vector2d> quarter;
  for (int i = 0; i < kAcrossEnd; ++i) quarter.emplace_back(x, y * i / kAcrossEnd);
  for (int i = 0; i < kAlongSide; ++i) quarter.emplace_back(x * (kAlongSide - i) / kAlongSide, y);
  std::vector<Eigen::Vector2d> all = quarter;
  all.emplace_back(0, y);
  for (size_t i = quarter.size(); i-- > 0;) all.emplace_back(-quarter[i].x(), quarter[i].y());
  for (size_t i = all.size() - 1; i-- > 1;) all.emplace_back(all[i].x(), -all[i].y());
  return all;
}

}  // namespace

BisectedMesh::BisectedMesh(const geometry::Vehicle& vehicle, const BowlSurface& surface) : surface_(surface) {
  const double length = surface.floor_length_m / 2 + surface.rise_m;
  const double width = surface.floor_width_m / 2 + surface.rise_m;
  metres_per_unit_ = std::max({length, width, surface.height_m}) / kLargestUnit;

  const std::vector<Eigen::Vector2d> inner = outline(vehicle);
  const int spokes = static_cast<int>(inner.size());
  const int rings = static_cast<int>(kRings.size());
  for (const Eigen::Vector2d& start : inner) {
    const Eigen::Vector2d rim = surface.rim_towards(start);
    for (const double part : kRings) add_place(start + part * (rim - start), part == 1);
  }
  for (int spoke = 0; spoke < spokes; ++spoke) {
    const int here = spoke * rings, next = (spoke + 1) % spokes * rings;
    for (int ring = 0; ring + 1 < rings; ++ring)
      add_quadrangle(here + ring, here + ring + 1, next + ring + 1, next + ring);
  }
}

int BisectedMesh::add_place(const Eigen::Vector2d& ground, bool on_rim) {
  const Eigen::Vector2d units = ground / metres_per_unit_;
  // Whole numbers that rounding made a little larger or smaller stay what they are.
  const auto lattice = [](double u) {
    const double nearest = std::round(u);
    return std::abs(u - nearest) < 1e-6 ? static_cast<int>(nearest) : outwards(u);
  };
  places_.emplace_back(std::clamp(lattice(units.x()), -kLargestUnit, kLargestUnit),
                       std::clamp(lattice(units.y()), -kLargestUnit, kLargestUnit));
  on_rim_.push_back(on_rim);
  return static_cast<int>(places_.size()) - 1;
}

void BisectedMesh::add_triangle(const std::array<int, 3>& corner) {
  const int index = static_cast<int>(triangles_.size());
  triangles_.push_back({corner});
  for (int i = 0; i < 3; ++i) {
    const auto [edge, fresh] = triangles_of_edge_.try_emplace(edge_key(corner[i], corner[(i + 1) % 3]),
                                                              std::array<int, 2>{index, -1});
    if (!fresh) edge->second[edge->second[0] >= 0] = index;
  }
}

/// Of the two diagonals the shorter, which makes the better triangles.
void BisectedMesh::add_quadrangle(int a, int b, int c, int d) {
  if ((ground(a) - ground(c)).norm() <= (ground(b) - ground(d)).norm()) {
    add_triangle({b, c, a});
    add_triangle({d, a, c});
  } else {
    add_triangle({a, b, d});
    add_triangle({c, d, b});
  }
}

double BisectedMesh::size_m(const Triangle& triangle) const {
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = std::max(longest, (ground(triangle.corner[i]) - ground(triangle.corner[(i + 1) % 3])).norm());
  return longest;
}

/// Across the edge that is to be cut; -1 where nothing is.
int BisectedMesh::neighbour(int triangle) const {
  const auto& corner = triangles_[triangle].corner;
  const auto& both = triangles_of_edge_.at(edge_key(corner[1], corner[2]));
  return both[0] == triangle ? both[1] : both[0];
}

void BisectedMesh::cut(int triangle) {
  const auto& corner = triangles_[triangle].corner;
  const uint64_t edge = edge_key(corner[1], corner[2]);
  int other = neighbour(triangle);
  const auto cut_elsewhere = [&] {
    const auto& its = triangles_[other].corner;
    return edge_key(its[1], its[2]) != edge;
  };
  if (other >= 0 && cut_elsewhere()) {
    cut(other);
    other = neighbour(triangle);
  }
  const int middle = middle_of(triangles_[triangle].corner[1], triangles_[triangle].corner[2], other < 0);
  halve(triangle, middle);
  if (other >= 0) halve(other, middle);
  triangles_of_edge_.erase(edge);
}

/// An edge of the rim, which has one triangle alone, gets its middle on the rim.
int BisectedMesh::middle_of(int a, int b, bool alone) {
  Eigen::Vector2d middle = 0.5 * (ground(a) + ground(b));
  const bool on_rim = alone && on_rim_[a] && on_rim_[b];
  if (on_rim) middle = surface_.rim_towards(middle);
  return add_place(middle, on_rim);
}

void BisectedMesh::halve(int triangle, int middle) {
  const std::array<int, 3> corner = triangles_[triangle].corner;
  triangles_[triangle].cut = true;
  for (int i = 0; i < 3; i += 2) {  // the two edges that stay whole
    for (int& of_edge : triangles_of_edge_.at(edge_key(corner[i], corner[(i + 1) % 3])))
      if (of_edge == triangle) of_edge = -1;
  }
  add_triangle({middle, corner[0], corner[1]});
  add_triangle({middle, corner[2], corner[0]});
}

}  // namespace svchain::bowl
