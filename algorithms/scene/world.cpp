#include "algorithms/scene/world.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scene/asphalt.h"
#include "algorithms/scene/motion.h"
#include "algorithms/scene/paint.h"
#include "algorithms/scene/shapes.h"

namespace svchain::scene {

namespace {

constexpr int kWindows = 3;        // levels of full size
constexpr int kSmallestSide = 80;  // texels of the coarsest level, at least

std::vector<GroundLevel> make_ground(const Scene& scene) {
  const double finest =
      scene.ground.metres_per_texel > 0 ? scene.ground.metres_per_texel : scene.rig.vehicle.length_m / 960;
  const double half_extent = scene.ground.half_extent_m > 0 ? scene.ground.half_extent_m : 1280 * finest;
  const int side = std::max(2, static_cast<int>(std::ceil(half_extent / finest / 16))) * 32;

  std::vector<Patch> paint_list = scene.paint;
  for (const auto& board : scene.charts) {
    const auto list = patches(board);
    paint_list.insert(paint_list.end(), list.begin(), list.end());
  }
  const Asphalt asphalt(scene.ground, finest, scene.seed);
  std::vector<GroundLevel> levels;
  for (int i = 0; i < kWindows; ++i) {
    const double metres_per_texel = std::ldexp(finest, i);
    levels.push_back({metres_per_texel, metres_per_texel * side / 2, asphalt.lay(i, side)});
    for (const auto& patch : paint_list) {
      paint(levels.back().texture, metres_per_texel, levels.back().half_extent_m, patch);
    }
  }
  while (levels.back().texture.width >= 2 * kSmallestSide && levels.back().texture.width % 2 == 0) {
    const GroundLevel& last = levels.back();
    levels.push_back({2 * last.metres_per_texel, last.half_extent_m, halved(last.texture)});
  }
  return levels;
}

}  // namespace

World::World(Scene scene)
    : scene_(std::move(scene)),
      ground_(make_ground(scene_)),
      panorama_(make_panorama(scene_.sky, scene_.ground.colour, largest_yaw_rad(scene_.path), scene_.seed)) {}

std::optional<size_t> World::level_for(double footprint_m, double distance_m) const {
  const double ideal = std::log2(std::max(footprint_m, 1e-9) / ground_.front().metres_per_texel);
  const double last = static_cast<double>(ground_.size() - 1);
  auto level = static_cast<size_t>(std::lround(std::clamp(ideal, 0.0, last)));
  const auto reaches = [&](const GroundLevel& g) {
    return distance_m + 2 * g.metres_per_texel < g.half_extent_m;
  };
  while (level < ground_.size() && !reaches(ground_[level])) ++level;
  if (level == ground_.size()) return std::nullopt;
  return level;
}

}  // namespace svchain::scene
