#pragma once
// Where the vehicle is and when its cameras say that they looked. Pure functions, any thread.

#include <cstdint>

#include "algorithms/scene/scene.h"

namespace svchain::scene {

/// The vehicle's pose at a time; the identity at 0 s.
Pose2 world_from_vehicle(const Path& path, double time_s);

/// The farthest that the vehicle comes from where it was at time 0, and the most that it turns.
double largest_travel_m(const Path& path);
double largest_yaw_rad(const Path& path);

/// The time stamp of a camera's frame: frame / rate, late or early by the scene's jitter, the same in every
/// run. Not below 0.
int64_t capture_time_ns(const Scene& scene, size_t camera, uint64_t frame);

}  // namespace svchain::scene
