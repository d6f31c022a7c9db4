#include "algorithms/scene/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/scene/hash.h"

namespace svchain::scene {

Pose2 world_from_vehicle(const Path& path, double time_s) {
  if (path.travel_m == 0) return {};
  const double along = path.travel_m * std::sin(2 * std::numbers::pi * time_s / path.period_s);
  const double yaw = along / path.turn_radius_m;
  return {path.turn_radius_m * std::sin(yaw), path.turn_radius_m * (1 - std::cos(yaw)), yaw};
}

double largest_travel_m(const Path& path) {
  return path.travel_m;
}

double largest_yaw_rad(const Path& path) {
  return path.travel_m / path.turn_radius_m;
}

int64_t capture_time_ns(const Scene& scene, size_t camera, uint64_t frame) {
  const double jitter = 2 * unit(hash(scene.seed, camera, frame, 0x7457u)) - 1;
  const double late_s = jitter * scene.timestamp_jitter_ms / 1e3;
  return std::max<int64_t>(0,
                           std::llround((static_cast<double>(frame) / scene.frame_rate_hz + late_s) * 1e9));
}

}  // namespace svchain::scene
