#include "algorithms/car/rasteriser.h"

#include <algorithm>
#include <array>

namespace svchain::car {
namespace {

constexpr float kOverlap = 0.002f;  // samples that neighbours share along their edge

int whole_above(float v) {  // of a number >= 0
  const int whole = static_cast<int>(v);
  return whole + (static_cast<float>(whole) < v);
}

/// First and last whole number within [low, high] and 0..size - 1.
struct Range {
  int first, last;
  Range(float low, float high, int size)
      : first(whole_above(std::clamp(low, 0.0f, static_cast<float>(size)))),
        last(high < 0 ? -1 : static_cast<int>(std::min(high, static_cast<float>(size - 1)))) {}
};

/// A corner's share at a place: 0 on the edge p q against it, 1 in the corner. Places count from (x0, y0).
struct Edge {
  float along_x, along_y, at_first, inverse_x;

  template <class Point>
  Edge(const Point& p, const Point& q, double inverse_area, float x0, float y0) {
    const double dx = (static_cast<double>(p.y) - q.y) * inverse_area;
    const double dy = (static_cast<double>(q.x) - p.x) * inverse_area;
    along_x = static_cast<float>(dx);
    along_y = static_cast<float>(dy);
    at_first =
        static_cast<float>(dx * (static_cast<double>(x0) - p.x) + dy * (static_cast<double>(y0) - p.y));
    inverse_x = along_x == 0 ? 0 : 1 / along_x;
  }
  /// Leaves of a row's range what lies on the corner's side.
  void narrow(float down, float& low, float& high) const {
    const float share = at_first + down * along_y, crossing = -share * inverse_x;
    if (along_x > 0) {
      low = std::max(low, crossing - kOverlap);
    } else if (along_x < 0) {
      high = std::min(high, crossing + kOverlap);
    } else if (share < 0) {
      high = -1;
    }
  }
};

}  // namespace

Rasteriser::Point Rasteriser::projected(const Eigen::Vector3f& seen) const {
  const float inverse = 1 / seen.z();
  return {centre_.x() + focal_ * seen.x() * inverse, centre_.y() + focal_ * seen.y() * inverse, inverse};
}

void Rasteriser::draw(const CarModel& model, uint32_t first_translucent, const Viewpoint& viewpoint,
                      double near_m, const cv::Rect& rectangle) {
  width_ = rectangle.width * kSamplesPerSide;
  height_ = rectangle.height * kSamplesPerSide;
  const auto count = static_cast<size_t>(width_) * height_;
  opaque_.assign(count, {});
  translucent_.assign(count, {});

  near_ = static_cast<float>(near_m);
  focal_ = static_cast<float>(viewpoint.focal_px * kSamplesPerSide);
  const Eigen::Vector2d corner(rectangle.x - 0.25, rectangle.y - 0.25);
  centre_ = ((viewpoint.centre_px - corner) * kSamplesPerSide).cast<float>();
  const Eigen::Matrix3f rotation = viewpoint.camera_from_vehicle.cast<float>();
  const Eigen::Vector3f eye = viewpoint.eye.cast<float>();
  seen_.resize(model.vertices.size());
  points_.resize(model.vertices.size());
  for (size_t i = 0; i < model.vertices.size(); ++i) {
    seen_[i] = rotation * (model.vertices[i].position - eye);
    if (seen_[i].z() >= near_) points_[i] = projected(seen_[i]);
  }

  const auto triangles = static_cast<uint32_t>(model.triangle_count());
  for (uint32_t t = 0; t < triangles; ++t) {
    const uint32_t* const i = &model.indices[3 * t];
    std::vector<Layer>& layer = t < first_translucent ? opaque_ : translucent_;
    const int before = (seen_[i[0]].z() >= near_) + (seen_[i[1]].z() >= near_) + (seen_[i[2]].z() >= near_);
    if (before == 3) {
      draw(t, layer, points_[i[0]], points_[i[1]], points_[i[2]]);
    } else if (before > 0) {
      draw_clipped(t, layer, {seen_[i[0]], seen_[i[1]], seen_[i[2]]});
    }
  }
}

/// What lies before the near plane: a triangle or a quadrangle.
void Rasteriser::draw_clipped(uint32_t triangle, std::vector<Layer>& layer,
                              const std::array<Eigen::Vector3f, 3>& seen) {
  std::array<Point, 4> polygon;
  size_t corners = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f &a = seen[i], &b = seen[(i + 1) % 3];
    const bool a_before = a.z() >= near_, b_before = b.z() >= near_;
    if (a_before) polygon[corners++] = projected(a);
    if (a_before == b_before) continue;
    Eigen::Vector3f cut = a + (b - a) * ((near_ - a.z()) / (b.z() - a.z()));
    cut.z() = near_;
    polygon[corners++] = projected(cut);
  }
  for (size_t i = 2; i < corners; ++i) draw(triangle, layer, polygon[0], polygon[i - 1], polygon[i]);
}

/// Row by row the samples between the edges, which reach a little too far, so that nothing shows between two
/// triangles; of equal depths the first drawn stays.
void Rasteriser::draw(uint32_t triangle, std::vector<Layer>& layer, const Point& a, const Point& b,
                      const Point& c) {
  const Range columns(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width_);
  const Range rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height_);
  if (columns.first > columns.last || rows.first > rows.last) return;
  // In double: near the eye, corners lie far outside of the picture.
  const double area = (static_cast<double>(b.x) - a.x) * (static_cast<double>(c.y) - a.y) -
                      (static_cast<double>(c.x) - a.x) * (static_cast<double>(b.y) - a.y);
  if (area == 0) return;
  const auto x0 = static_cast<float>(columns.first), y0 = static_cast<float>(rows.first);
  const std::array<Edge, 3> edges = {Edge(c, a, 1 / area, x0, y0), Edge(a, b, 1 / area, x0, y0),
                                     Edge(b, c, 1 / area, x0, y0)};
  // Inverse depth is a plane over the picture.
  const float db = b.inverse - a.inverse, dc = c.inverse - a.inverse;
  const float depth_x = edges[0].along_x * db + edges[1].along_x * dc;
  const float depth_y = edges[0].along_y * db + edges[1].along_y * dc;
  const float depth_0 = a.inverse + edges[0].at_first * db + edges[1].at_first * dc;

  for (int y = rows.first; y <= rows.last; ++y) {
    const auto down = static_cast<float>(y - rows.first);
    float low = 0, high = static_cast<float>(columns.last - columns.first);
    for (const Edge& edge : edges) edge.narrow(down, low, high);
    if (low > high) continue;
    const size_t row = static_cast<size_t>(y) * width_ + columns.first;
    const float depth = depth_0 + down * depth_y;
    for (int x = whole_above(low); x <= static_cast<int>(high); ++x) {
      const float inverse = depth + static_cast<float>(x) * depth_x;
      if (inverse <= opaque_[row + x].inverse || inverse <= layer[row + x].inverse) continue;
      layer[row + x] = {inverse, triangle};
    }
  }
}

}  // namespace svchain::car
