#include "algorithms/bowl/viewpoint_path.h"

#include <Eigen/Geometry>
#include <cmath>

#include "algorithms/bowl/viewpoint_presets.h"
#include "tests/allocation_count.h"
#include "tests/bowl/bowls.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;

namespace {

Viewpoint car_preset(const std::string& name) {
  return *preset(name, kCar, default_surface(kCar));
}

double turn_deg(const Viewpoint& a, const Viewpoint& b) {
  const Eigen::Matrix3d from = Perspective(a, {880, 1080}).vehicle_from_picture();
  const Eigen::Matrix3d to = Perspective(b, {880, 1080}).vehicle_from_picture();
  return Eigen::AngleAxisd(from.transpose() * to).angle() * 180 / M_PI;
}

void check_same(const Viewpoint& a, const Viewpoint& b) {
  CHECK((a.eye_m - b.eye_m).norm() < 1e-9);
  CHECK((a.target_m - b.target_m).norm() < 1e-9);
  CHECK((a.up.normalized() - b.up.normalized()).norm() < 1e-9);
  CHECK(a.field_of_view_deg == Approx(b.field_of_view_deg));
}

/// Speed of the eye, from differences.
Eigen::Vector3d speed(const ViewpointPath& path, double time_s, double step_s) {
  return (path.at(time_s + step_s).eye_m - path.at(time_s).eye_m) / step_s;
}

}  // namespace

TEST_CASE("the way between any two presets begins and ends at them, past vehicle, ground and wall") {
  for (const geometry::Vehicle& vehicle : {kToy, kCar, kVan}) {
    for (const BowlSurface& surface : bowls(vehicle)) {
      for (const std::string& from : preset_names()) {
        for (const std::string& to : preset_names()) {
          const Viewpoint a = *preset(from, vehicle, surface), b = *preset(to, vehicle, surface);
          check_same(mixed(a, b, 0), a);
          check_same(mixed(a, b, 1), b);
          Viewpoint before = a;
          for (int i = 1; i <= 50; ++i) {
            const Viewpoint way = mixed(a, b, i / 50.0);
            const Viewpoint now = inside_bowl(way, surface);
            if (surface.exponent > 1) REQUIRE(now == way);  // only the cone's wall is in the way
            CAPTURE(from, to, i, vehicle.length_m, surface.exponent);
            REQUIRE(check(now, vehicle, surface).empty());
            REQUIRE(turn_deg(before, now) < 20);
            before = now;
          }
        }
      }
    }
  }
}

TEST_CASE("a viewpoint goes around the vehicle by the shorter turn") {
  const Viewpoint front = car_preset("front"), left = car_preset("left"), rear = car_preset("rear");
  const Eigen::Vector3d half_way = mixed(front, left, 0.5).eye_m;
  CHECK(std::atan2(half_way.y(), half_way.x()) == Approx(M_PI / 4));
  CHECK(half_way.head<2>().norm() > 1.2 * kCar.length_m);
  const Viewpoint right_front = mixed(car_preset("right"), front, 0.5);
  CHECK(right_front.eye_m.y() < 0);
  CHECK(right_front.eye_m.x() > 0);
  CHECK(mixed(front, rear, 0.5).eye_m.y() > 1);  // half a turn: counter-clockwise
  CHECK(mixed(rear, front, 0.5).eye_m.y() < -1);
}

TEST_CASE("a path passes its key frames at their times with continuous speed") {
  const std::vector<KeyFrame> frames = {{1, car_preset("top")},
                                        {2, car_preset("chase")},
                                        {4, car_preset("left")},
                                        {4.5, car_preset("wheel_front_left")},
                                        {9, car_preset("front")}};
  const ViewpointPath path(frames, false);
  for (const KeyFrame& frame : frames) check_same(path.at(frame.time_s), frame.viewpoint);
  check_same(path.at(-5), frames.front().viewpoint);
  check_same(path.at(100), frames.back().viewpoint);
  for (const KeyFrame& frame : frames) {
    if (frame.time_s == 1 || frame.time_s == 9) continue;
    CHECK((speed(path, frame.time_s, 1e-6) - speed(path, frame.time_s, -1e-6)).norm() < 1e-3);
  }
  CHECK(speed(path, 1, 1e-6).norm() < 1e-3);  // it starts gently
  for (double t = 0.5; t < 10; t += 0.01) REQUIRE(check(path.at(t), kCar, default_surface(kCar)).empty());
}

TEST_CASE("the orbit is an even full turn in 12 seconds, over and over, that looks as the chase does") {
  for (const geometry::Vehicle& vehicle : {kToy, kCar, kVan}) {
    const ViewpointPath path = orbit(vehicle, default_surface(vehicle));
    const Viewpoint chase = *preset("chase", vehicle, default_surface(vehicle));
    CHECK(path.loop());
    CHECK(path.end_s() - path.begin_s() == Approx(12));
    CHECK((path.at(0).eye_m - chase.eye_m).norm() < 1e-9);
    const double radius = chase.eye_m.head<2>().norm();
    for (double t = 0; t < 26; t += 0.37) {
      const Viewpoint now = path.at(t);
      const double angle = M_PI + 2 * M_PI * t / 12;
      CHECK((now.eye_m - Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), chase.eye_m.z()))
                .norm() < 1e-6 * radius);
      const double ahead = chase.target_m.x() / chase.eye_m.x();
      CHECK((now.target_m.head<2>() - ahead * now.eye_m.head<2>()).norm() < 0.002 * radius);
      CHECK(check(now, vehicle, default_surface(vehicle)).empty());
    }
  }
}

TEST_CASE("a loop turns on where it closes, with continuous speed") {
  const Viewpoint rear = car_preset("rear"), left = car_preset("left"), front = car_preset("front");
  const ViewpointPath path({{0, rear}, {1, car_preset("right")}, {3, front}, {4, left}, {6, rear}}, true);
  check_same(path.at(6.5), path.at(0.5));
  check_same(path.at(-0.5), path.at(5.5));
  CHECK((speed(path, 6, 1e-6) - speed(path, 6, -1e-6)).norm() < 1e-3);
  CHECK(speed(path, 6, 1e-6).norm() > 1);
}

TEST_CASE("key frames whose times do not rise and loops that stay open are refused") {
  const Viewpoint rear = car_preset("rear"), left = car_preset("left");
  CHECK_THROWS_AS(ViewpointPath({}, false), std::invalid_argument);
  CHECK_THROWS_AS(ViewpointPath({{1, rear}, {1, left}}, false), std::invalid_argument);
  CHECK_THROWS_AS(ViewpointPath({{1, rear}, {2, left}}, true), std::invalid_argument);
  CHECK_NOTHROW(ViewpointPath({{1, rear}}, false));
}

TEST_CASE("asking a path allocates nothing") {
  const ViewpointPath path = orbit(kCar, default_surface(kCar));
  const size_t before = allocation_count();
  double sum = 0;
  for (double t = 0; t < 20; t += 0.1) sum += path.at(t).eye_m.z();
  CHECK(allocation_count() == before);
  CHECK(sum > 0);
}
