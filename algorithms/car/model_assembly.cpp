#include "algorithms/car/model_assembly.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace svchain::car {
namespace {

/// Bytes of floats, as a key.
template <size_t N>
struct FloatsHash {
  size_t operator()(const std::array<float, N>& floats) const {
    uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const float value : floats) {
      uint32_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 0xbf58476d1ce4e5b9u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

template <size_t N>
using Numbering = std::unordered_map<std::array<float, N>, uint32_t, FloatsHash<N>>;

/// Zero has two signs but is one place.
float plain(float value) {
  return value + 0.0f;
}

std::array<float, 3> place_key(const Eigen::Vector3f& p) {
  return {plain(p.x()), plain(p.y()), plain(p.z())};
}

/// Twice the area along the normal.
Eigen::Vector3f plane(const LooseTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (b.position - a.position).cross(c.position - a.position);
}

/// Which triangles meet at each place: those of place p are members[first[p]] to members[first[p + 1] - 1].
struct Meetings {
  std::vector<uint32_t> place_of_corner, first, members;

  explicit Meetings(std::span<const LooseTriangle> triangles) {
    Numbering<3> places;
    for (const LooseTriangle& triangle : triangles)
      for (const Vertex& corner : triangle.corners)
        place_of_corner.push_back(
            places.try_emplace(place_key(corner.position), static_cast<uint32_t>(places.size()))
                .first->second);
    first.assign(places.size() + 1, 0);
    for (const uint32_t place : place_of_corner) ++first[place + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    members.resize(place_of_corner.size());
    std::vector<uint32_t> next(first.begin(), first.end() - 1);
    for (size_t corner = 0; corner < place_of_corner.size(); ++corner)
      members[next[place_of_corner[corner]]++] = static_cast<uint32_t>(corner / 3);
  }
};

}  // namespace

void smooth_normals(std::span<LooseTriangle> triangles, float crease_deg) {
  const float least_cosine = std::cos(crease_deg * std::numbers::pi_v<float> / 180);
  const Meetings meetings(triangles);
  std::vector<Eigen::Vector3f> planes, units;
  for (const LooseTriangle& triangle : triangles) {
    planes.push_back(plane(triangle));
    units.push_back(planes.back().stableNormalized());
  }
  for (size_t corner = 0; corner < 3 * triangles.size(); ++corner) {
    const uint32_t place = meetings.place_of_corner[corner];
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    // Where very many meet, as at a pole, the first ones tell enough.
    const uint32_t last = std::min(meetings.first[place + 1], meetings.first[place] + 256);
    for (uint32_t i = meetings.first[place]; i < last; ++i)
      if (units[meetings.members[i]].dot(units[corner / 3]) >= least_cosine)
        sum += planes[meetings.members[i]];
    if (sum.squaredNorm() == 0) sum = units[corner / 3];
    triangles[corner / 3].corners[corner % 3].normal = sum.stableNormalized();
  }
}

CarModel assemble(const std::vector<Material>& materials, std::span<const LooseTriangle> triangles) {
  std::vector<std::vector<uint32_t>> of_material(materials.size());
  for (size_t i = 0; i < triangles.size(); ++i)
    of_material[triangles[i].material].push_back(static_cast<uint32_t>(i));
  std::vector<uint32_t> order(materials.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_partition(order.begin(), order.end(), [&](uint32_t m) { return materials[m].opaque(); });

  CarModel model;
  Numbering<6> vertices;
  for (const uint32_t m : order) {
    const auto first = static_cast<uint32_t>(model.indices.size());
    for (const uint32_t t : of_material[m]) {
      std::array<uint32_t, 3> corners;
      const Eigen::Vector3f along = plane(triangles[t]);
      Eigen::Vector3f outwards = Eigen::Vector3f::Zero();
      for (size_t i = 0; i < 3; ++i) {
        const auto& [p, n] = triangles[t].corners[i];
        outwards += n;
        const std::array<float, 6> key = {plain(p.x()), plain(p.y()), plain(p.z()),
                                          plain(n.x()), plain(n.y()), plain(n.z())};
        const auto [entry, is_new] = vertices.try_emplace(key, static_cast<uint32_t>(vertices.size()));
        if (is_new) model.vertices.push_back(triangles[t].corners[i]);
        corners[i] = entry->second;
      }
      if (along.squaredNorm() == 0) continue;
      if (along.dot(outwards) < 0) std::swap(corners[1], corners[2]);
      model.indices.insert(model.indices.end(), corners.begin(), corners.end());
    }
    const auto count = static_cast<uint32_t>(model.indices.size()) - first;
    if (count > 0) model.parts.push_back({materials[m], first, count});
  }
  return model;
}

}  // namespace svchain::car
