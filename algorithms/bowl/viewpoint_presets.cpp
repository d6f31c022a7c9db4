#include "algorithms/bowl/viewpoint_presets.h"

#include <algorithm>
#include <array>

namespace svchain::bowl {
namespace {

constexpr double kKeptFromWall = 0.9;  // of the way from the target to the wall

/// Eye and target, x and z in vehicle lengths, y in lengths too but for `at_side`, in half widths.
struct Preset {
  const char* name;
  double eye[3], target[3];
  double eye_at_side, target_at_side;
  double up[3];
  double field_of_view_deg;
};

constexpr std::array<Preset, 10> kPresets = {{
    {"top", {0, 0, 2.1}, {0, 0, 0}, 0, 0, {1, 0, 0}, 55},
    {"chase", {-1.5, 0, 1.08}, {-0.25, 0, 0}, 0, 0, {0, 0, 1}, 52},
    {"front", {1.45, 0, 0.8}, {0.3, 0, 0}, 0, 0, {0, 0, 1}, 48},
    {"left", {0, 1.25, 0.8}, {0, 0, 0}, 0, 0.9, {0, 0, 1}, 58},
    {"right", {0, -1.25, 0.8}, {0, 0, 0}, 0, -0.9, {0, 0, 1}, 58},
    {"rear", {-1.45, 0, 0.8}, {-0.3, 0, 0}, 0, 0, {0, 0, 1}, 48},
    {"wheel_front_left", {0.62, 0.3, 0.5}, {0.3, 0, 0}, 1, 1, {0, 0, 1}, 55},
    {"wheel_front_right", {0.62, -0.3, 0.5}, {0.3, 0, 0}, -1, -1, {0, 0, 1}, 55},
    {"wheel_rear_left", {-0.62, 0.3, 0.5}, {-0.3, 0, 0}, 1, 1, {0, 0, 1}, 55},
    {"wheel_rear_right", {-0.62, -0.3, 0.5}, {-0.3, 0, 0}, -1, -1, {0, 0, 1}, 55},
}};

Eigen::Vector3d scaled(const double (&place)[3], double at_side, const geometry::Vehicle& vehicle) {
  return vehicle.length_m * Eigen::Vector3d(place[0], place[1], place[2]) +
         Eigen::Vector3d(0, at_side * vehicle.width_m / 2, 0);
}

}  // namespace

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Preset& p : kPresets) all.emplace_back(p.name);
    return all;
  }();
  return names;
}

std::optional<Viewpoint> preset(const std::string& name, const geometry::Vehicle& vehicle,
                                const BowlSurface& surface) {
  const auto found = std::ranges::find(kPresets, name, &Preset::name);
  if (found == kPresets.end()) return std::nullopt;
  Viewpoint viewpoint;
  viewpoint.eye_m = scaled(found->eye, found->eye_at_side, vehicle);
  viewpoint.target_m = scaled(found->target, found->target_at_side, vehicle);
  viewpoint.up = Eigen::Vector3d(found->up);
  viewpoint.field_of_view_deg = found->field_of_view_deg;
  return inside_bowl(viewpoint, surface);
}

Viewpoint inside_bowl(Viewpoint viewpoint, const BowlSurface& surface) {
  // From a little above the target, which itself may lie on the floor.
  const Eigen::Vector3d sight = viewpoint.eye_m - viewpoint.target_m;
  const Eigen::Vector3d start = viewpoint.target_m + 0.01 * sight;
  if (const auto wall = surface.intersect(start, sight)) {
    const Eigen::Vector3d kept = viewpoint.target_m + kKeptFromWall * (*wall - viewpoint.target_m);
    if ((kept - viewpoint.target_m).norm() < sight.norm()) viewpoint.eye_m = kept;
  }
  return viewpoint;
}

}  // namespace svchain::bowl
