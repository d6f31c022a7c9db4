#include "algorithms/scene/motion.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;

TEST_CASE("the vehicle begins at the world's origin and comes back after a period") {
  const scene::Path path{1.5, 8, 20};
  for (const double time_s : {0.0, 8.0, 80.0}) {
    const auto pose = scene::world_from_vehicle(path, time_s);
    CHECK(pose.x_m == Approx(0).margin(1e-9));
    CHECK(pose.y_m == Approx(0).margin(1e-9));
    CHECK(pose.yaw_rad == Approx(0).margin(1e-9));
  }
}

TEST_CASE("the vehicle drives where it heads") {
  const scene::Path path{1.5, 8, 20};
  const auto before = scene::world_from_vehicle(path, 1.0);
  const auto after = scene::world_from_vehicle(path, 1.001);
  CHECK(after.x_m > before.x_m);
  CHECK(std::atan2(after.y_m - before.y_m, after.x_m - before.x_m) == Approx(before.yaw_rad).margin(1e-4));
}

TEST_CASE("the vehicle never comes farther than its path's reach") {
  const scene::Path path{1.5, 8, 2};
  for (int i = 0; i < 100; ++i) {
    const auto pose = scene::world_from_vehicle(path, 0.08 * i);
    CHECK(std::hypot(pose.x_m, pose.y_m) <= scene::largest_travel_m(path));
    CHECK(std::abs(pose.yaw_rad) <= scene::largest_yaw_rad(path));
  }
}

TEST_CASE("time stamps stay within the jitter of the frame's time and differ between cameras") {
  scene::Scene scene = testing::small_scene();
  scene.frame_rate_hz = 25;
  scene.timestamp_jitter_ms = 3;
  bool differ = false;
  for (uint64_t frame = 1; frame < 200; ++frame) {
    for (size_t camera = 0; camera < 4; ++camera) {
      const int64_t stamp = scene::capture_time_ns(scene, camera, frame);
      CHECK(std::abs(stamp - static_cast<int64_t>(frame) * 40'000'000) <= 3'000'000);
      CHECK(stamp == scene::capture_time_ns(scene, camera, frame));
      CHECK(stamp > scene::capture_time_ns(scene, camera, frame - 1));
      differ = differ || stamp != scene::capture_time_ns(scene, 0, frame);
    }
  }
  CHECK(differ);
}

TEST_CASE("without jitter time stamps are the frame's time exactly") {
  const scene::Scene scene = testing::small_scene();
  CHECK(scene::capture_time_ns(scene, 2, 0) == 0);
  CHECK(scene::capture_time_ns(scene, 2, 30) == 1'000'000'000);
}
