#include "algorithms/scene/paint.h"

#include <algorithm>
#include <cmath>

namespace svchain::scene {

namespace {

/// Unit normal to the inside and offset: a point's distance from the edge, positive inside.
struct Edge {
  double nx, ny, offset;
  double distance(double x, double y) const { return nx * x + ny * y + offset; }
};

std::vector<Edge> edges_of(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<Edge> edges;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d along = (corners[(i + 1) % corners.size()] - a).normalized();
    edges.push_back({-along.y(), along.x(), along.y() * a.x() - along.x() * a.y()});
  }
  return edges;
}

/// Area of the unit square about (x, y) that lies inside every edge: the square is clipped edge by edge
/// (Sutherland & Hodgman 1974).
double covered_area(const std::vector<Edge>& edges, double x, double y) {
  constexpr size_t kMost = 64;
  Eigen::Vector2d corners[2][kMost] = {
      {{x - 0.5, y - 0.5}, {x + 0.5, y - 0.5}, {x + 0.5, y + 0.5}, {x - 0.5, y + 0.5}}};
  size_t count = 4;
  int now = 0;
  for (const Edge& edge : edges) {
    const double middle = edge.distance(x, y);
    if (middle > 0.71) continue;
    if (middle < -0.71) return 0;
    size_t kept = 0;
    for (size_t i = 0; i < count && kept + 2 <= kMost; ++i) {
      const Eigen::Vector2d& a = corners[now][i];
      const Eigen::Vector2d& b = corners[now][(i + 1) % count];
      const double da = edge.distance(a.x(), a.y());
      const double db = edge.distance(b.x(), b.y());
      if (da >= 0) corners[1 - now][kept++] = a;
      if ((da >= 0) != (db >= 0)) corners[1 - now][kept++] = a + (b - a) * (da / (da - db));
    }
    now = 1 - now;
    count = kept;
  }
  double twice = 0;
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& a = corners[now][i];
    const Eigen::Vector2d& b = corners[now][(i + 1) % count];
    twice += (a.x() - x) * (b.y() - y) - (b.x() - x) * (a.y() - y);
  }
  return twice / 2;
}

uint32_t mixed(uint32_t under, const Colour& over, int weight_256) {
  const auto channel = [&](int shift, int value) {
    const int below = static_cast<int>(under >> shift & 255);
    return static_cast<uint32_t>(below + (((value - below) * weight_256 + 128) >> 8)) << shift;
  };
  return channel(0, over.b) | channel(8, over.g) | channel(16, over.r);
}

}  // namespace

void paint(Texture& ground, double metres_per_texel, double half_extent_m, const Patch& patch) {
  std::vector<Eigen::Vector2d> corners;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = -low;
  for (const auto& corner : patch.corners_m) {
    corners.push_back((corner.array() + half_extent_m) / metres_per_texel - 0.5);
    low = low.cwiseMin(corners.back());
    high = high.cwiseMax(corners.back());
  }
  const std::vector<Edge> edges = edges_of(corners);
  const auto clamped = [](double v, int size) { return static_cast<int>(std::clamp(v, 0.0, size - 1.0)); };
  if (high.x() < -0.5 || high.y() < -0.5 || low.x() > ground.width || low.y() > ground.height) return;

  for (int y = clamped(low.y() - 1, ground.height); y <= clamped(high.y() + 1, ground.height); ++y) {
    // The part of this row within 0.71 texels of every edge's inside.
    double first = low.x() - 1;
    double last = high.x() + 1;
    for (const Edge& edge : edges) {
      const double rest = -(edge.ny * y + edge.offset + 0.71);
      if (edge.nx > 1e-9)
        first = std::max(first, rest / edge.nx);
      else if (edge.nx < -1e-9)
        last = std::min(last, rest / edge.nx);
      else if (rest > 0)
        last = -1;
    }
    if (last < 0 || first > ground.width - 1) continue;
    uint32_t* row = ground.row(y);
    const int end = clamped(std::floor(last), ground.width);
    for (int x = clamped(std::ceil(first), ground.width); x <= end; ++x) {
      const int weight = static_cast<int>(std::lround(256 * patch.opacity * covered_area(edges, x, y)));
      if (weight > 0) row[x] = mixed(row[x], patch.colour, weight);
    }
  }
}

}  // namespace svchain::scene
