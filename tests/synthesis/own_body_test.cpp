#include "algorithms/synthesis/own_body.h"

#include "tests/catch.h"

using namespace svchain;
using synthesis::sight_past_body;

namespace {

constexpr geometry::Vehicle kCar{4.8, 1.9};

}  // namespace

TEST_CASE("a side camera does not see the ground on the other side, nor close before the bumper") {
  CHECK(sight_past_body(kCar, {0.6, 1.0}, {0, -3}) == 0);
  CHECK(sight_past_body(kCar, {0.6, 1.0}, {2.5, -0.5}) == 0);
  CHECK(sight_past_body(kCar, {0.6, -1.0}, {-2.5, 0.5}) == 0);
}

TEST_CASE("cameras see all of their own and their corner zones") {
  for (const double y : {0.96, 1.5, 4.0})
    for (const double x : {-8.0, -2.0, 0.0, 2.0, 8.0}) {
      CHECK(sight_past_body(kCar, {0.6, 1.0}, {x, y}) == 1);
      CHECK(sight_past_body(kCar, {0.6, -1.0}, {x, -y}) == 1);
    }
  for (const double y : {-6.0, -1.0, 0.0, 1.0, 6.0}) {
    CHECK(sight_past_body(kCar, {2.35, 0}, {2.41, y}) == 1);
    CHECK(sight_past_body(kCar, {-2.35, 0}, {-2.41, y}) == 1);
  }
}

TEST_CASE("lines of sight along an axis are no exception") {
  CHECK(sight_past_body(kCar, {2.35, 0}, {-4, 0}) == 0);
  CHECK(sight_past_body(kCar, {2.35, 1.2}, {-4, 1.2}) == 1);
  CHECK(sight_past_body(kCar, {0, 1}, {0, -2}) == 0);
}

TEST_CASE("sight is lost smoothly around the body's corner") {
  double before = 1;
  for (double y = 0.9; y > -1; y -= 0.01) {  // metres
    const double sight = sight_past_body(kCar, {0.6, 1.0}, {3, y});
    CHECK(sight <= before);
    CHECK(before - sight < 0.3);
    before = sight;
  }
  CHECK(before == 0);
}

TEST_CASE("a camera on the roof looks over the vehicle") {
  CHECK(sight_past_body(kCar, {0.5, 0}, {5, 0}) == 1);
  CHECK(sight_past_body(kCar, {-1.8, 0.7}, {5, 0}) == 1);
}
