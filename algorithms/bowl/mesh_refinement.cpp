#include "algorithms/bowl/mesh_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace svchain::bowl {
namespace {

constexpr double kLargestWeightError = 6;        // 255ths
constexpr double kMeasuredPart = 0.85;           // of the tolerance: a little is left for what lies between
constexpr double kSmallest = 1.0 / 256;          // of the vehicle's length
constexpr double kSmallestAtBorder = 1.0 / 128;  // where the picture of the last camera ends

/// Parts that the three corners have in the places where a triangle is measured: the middles of its edges,
/// and four inside.
const std::array<Eigen::Vector3d, 7> kMeasured = {Eigen::Vector3d(0, 0.5, 0.5), Eigen::Vector3d(0.5, 0, 0.5),
                                                  Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(1, 1, 1) / 3,
                                                  Eigen::Vector3d(4, 1, 1) / 6, Eigen::Vector3d(1, 4, 1) / 6,
                                                  Eigen::Vector3d(1, 1, 4) / 6};

}  // namespace

MeshRefinement::MeshRefinement(const geometry::Rig& rig, const BowlSurface& surface,
                               const synthesis::BlendShape& shape, double tolerance_px)
    : sights_(rig, surface, shape),
      tolerance_px_(tolerance_px),
      least_m_(kSmallest * rig.vehicle.length_m),
      least_at_border_m_(kSmallestAtBorder * rig.vehicle.length_m),
      mesh_(rig.vehicle, surface) {
  for (size_t i = 0; i < mesh_.triangles().size(); ++i) {  // it grows on the way
    if (!mesh_.triangles()[i].cut && too_large(mesh_.triangles()[i])) mesh_.cut(static_cast<int>(i));
  }
  for (const auto& triangle : mesh_.triangles())
    for (const int place : triangle.corner) sight_of(pair_of(triangle), place);
  hold_weights();
}

int MeshRefinement::pair_of(const BisectedMesh::Triangle& triangle) const {
  const auto& c = triangle.corner;
  return pair_at(mesh_.ground(c[0]) + mesh_.ground(c[1]) + mesh_.ground(c[2]));
}

const PairSight& MeshRefinement::sight_of(int pair, int place) {
  const auto [found, fresh] = sights_at_[pair].try_emplace(place);
  if (fresh) found->second = sights_.at(pair, mesh_.ground(place));
  return found->second;
}

MeshRefinement::Cover MeshRefinement::cover(const BisectedMesh::Triangle& triangle, int pair) const {
  bool first = true, second = true;
  for (const int place : triangle.corner) {
    first = first && sight(pair, place).sees(0);
    second = second && sight(pair, place).sees(1);
  }
  return first && second ? kBoth : first ? kFirst : second ? kSecond : kNone;
}

bool MeshRefinement::too_large(const BisectedMesh::Triangle& triangle) {
  const double size = mesh_.size_m(triangle);
  if (size <= least_m_) return false;
  const int pair = pair_of(triangle);
  for (const int place : triangle.corner) sight_of(pair, place);
  const Cover shows = cover(triangle, pair);
  if (shows != kNone) return is_off(triangle, pair, shows);

  // Something of a triangle that is left out may be seen.
  const auto seen = [&](const Eigen::Vector3d& parts) {
    const auto& c = triangle.corner;
    return sights_
        .at(pair,
            parts[0] * mesh_.ground(c[0]) + parts[1] * mesh_.ground(c[1]) + parts[2] * mesh_.ground(c[2]))
        .shown();
  };
  const auto shown = [&](int place) { return sight(pair, place).shown(); };
  if (std::ranges::all_of(triangle.corner, shown)) return true;  // a hole between what is seen
  return size > least_at_border_m_ &&
         (std::ranges::any_of(triangle.corner, shown) || std::ranges::any_of(kMeasured, seen));
}

bool MeshRefinement::is_off(const BisectedMesh::Triangle& triangle, int pair, Cover cover) const {
  if (cover != kBoth) {
    const int alone = cover == kFirst ? 255 : 0;
    for (const int place : triangle.corner)
      if (std::abs(sight(pair, place).first_weight - alone) > kLargestWeightError) return true;
  }
  return std::ranges::any_of(
      kMeasured, [&](const Eigen::Vector3d& parts) { return is_off_at(triangle, pair, cover, parts); });
}

bool MeshRefinement::is_off_at(const BisectedMesh::Triangle& triangle, int pair, Cover cover,
                               const Eigen::Vector3d& parts) const {
  Eigen::Vector2d ground(0, 0);
  double weight = 0;
  for (int i = 0; i < 3; ++i) {
    ground += parts[i] * mesh_.ground(triangle.corner[i]);
    weight += parts[i] * sight(pair, triangle.corner[i]).first_weight;
  }
  if (cover != kBoth) weight = cover == kFirst ? 255 : 0;
  const PairSight there = sights_.at(pair, ground);
  if (!there.shown()) return mesh_.size_m(triangle) > least_at_border_m_;
  if (std::abs(weight - there.first_weight) > kLargestWeightError) return true;
  for (int which = 0; which < 2; ++which) {
    const bool used = which == 0 ? cover != kSecond && weight > 0 : cover != kFirst && weight < 255;
    if (!used) continue;
    if (!there.pixel[which]) return true;
    Eigen::Vector2d pixel(0, 0);
    for (int i = 0; i < 3; ++i) pixel += parts[i] * *sight(pair, triangle.corner[i]).pixel[which];
    if ((pixel - *there.pixel[which]).norm() > kMeasuredPart * tolerance_px_) return true;
  }
  return false;
}

void MeshRefinement::hold_weights() {
  for (const auto& triangle : mesh_.triangles()) {
    if (triangle.cut) continue;
    const int pair = pair_of(triangle);
    const Cover shows = cover(triangle, pair);
    if (shows != kFirst && shows != kSecond) continue;
    for (const int place : triangle.corner) held_weights_[pair][place] = shows == kFirst ? 255 : 0;
  }
}

int MeshRefinement::first_weight(int pair, int place) const {
  const auto held = held_weights_[pair].find(place);
  return held != held_weights_[pair].end() ? held->second : sight(pair, place).first_weight;
}

std::vector<ShownTriangle> MeshRefinement::shown() const {
  std::vector<ShownTriangle> all;
  for (const auto& triangle : mesh_.triangles()) {
    if (triangle.cut) continue;
    const int pair = pair_of(triangle);
    const Cover shows = cover(triangle, pair);
    if (shows == kNone) continue;
    const auto all_are = [&](int weight) {
      return std::ranges::all_of(triangle.corner,
                                 [&](int place) { return first_weight(pair, place) == weight; });
    };
    ShownTriangle one{triangle.corner, pair, -1};
    if (shows == kFirst || (shows == kBoth && all_are(255))) one.alone = pair;
    if (shows == kSecond || (shows == kBoth && all_are(0))) one.alone = (pair + 1) % 4;
    all.push_back(one);
  }
  return all;
}

}  // namespace svchain::bowl
