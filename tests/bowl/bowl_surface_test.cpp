#include "algorithms/bowl/bowl_surface.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/allocation_count.h"
#include "tests/bowl/bowls.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;

namespace {

/// Distance from the nearest of many points of the floor's edge.
double distance_by_search(const BowlSurface& surface, const Eigen::Vector2d& point) {
  constexpr int kPoints = 20000;
  double nearest = 1e9;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    const Eigen::Vector2d edge(surface.floor_length_m / 2 * std::cos(angle),
                               surface.floor_width_m / 2 * std::sin(angle));
    nearest = std::min(nearest, (edge - point).norm());
  }
  return nearest;
}

/// What marching along a ray in small steps finds.
struct Marched {
  std::optional<Eigen::Vector3d> hit;
  bool doubtful = false;  // it comes so near to the rim that the steps may miss on which side
};

Marched march(const BowlSurface& surface, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  constexpr double kStep = 0.01, kEnd = 45;
  const auto above = [&](double t) {
    const Eigen::Vector3d p = origin + t * direction;
    return p.z() - surface.height_at(p.head<2>());
  };
  Marched marched;
  double before = -1;
  bool was_inside = false;
  for (double t = 0; t < kEnd; t += kStep) {
    const Eigen::Vector2d ground = (origin + t * direction).head<2>();
    const double distance = surface.distance_from_floor(ground);
    const double now = above(t);
    if (std::abs(distance - surface.rise_m) < 0.03 && std::abs(now) < 0.3) marched.doubtful = true;
    const bool inside = distance <= surface.rise_m;
    if (t == 0 && inside && now < 0) return marched;                     // starts below
    if (was_inside && inside && before < 0 && now >= 0) return marched;  // comes through from below
    if (was_inside && inside && before >= 0 && now < 0) {
      double over = t - kStep, under = t;
      for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (over + under);
        (above(middle) >= 0 ? over : under) = middle;
      }
      marched.hit = origin + over * direction;
      return marched;
    }
    before = now;
    was_inside = inside;
  }
  return marched;
}

}  // namespace

TEST_CASE("a bowl is flat on its floor, as high as it says at the rim, and rises by its exponent") {
  for (const BowlSurface& surface : bowls(kCar)) {
    CHECK(surface.height_at({0, 0}) == 0);
    CHECK(surface.height_at({surface.floor_length_m / 2, 0}) == 0);
    CHECK(surface.height_at({0, -surface.floor_width_m / 2 - surface.rise_m}) == Approx(surface.height_m));
    const double half_way = surface.floor_length_m / 2 + surface.rise_m / 2;
    CHECK(surface.height_at({-half_way, 0}) ==
          Approx(surface.height_m * std::pow(0.5, surface.exponent)).margin(1e-12));
    CHECK(surface.inside_rim({half_way, 0}));
    CHECK_FALSE(surface.inside_rim({half_way + 0.51 * surface.rise_m, 0}));
  }
  // The corners of a rectangle are round.
  const BowlSurface usual = default_surface(kCar);
  const Eigen::Vector2d corner(usual.floor_length_m / 2, usual.floor_width_m / 2);
  CHECK(usual.distance_from_floor(corner + Eigen::Vector2d(3, 4)) == Approx(5));
}

TEST_CASE("the distance from an ellipse is that of the nearest point of its edge") {
  BowlSurface surface = default_surface(kVan);
  surface.shape = FloorShape::kEllipse;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-20, 20);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d point(i < 5 ? 0 : place(random), i >= 5 && i < 10 ? 0 : place(random));
    const Eigen::Vector2d part(2 * point.x() / surface.floor_length_m, 2 * point.y() / surface.floor_width_m);
    CAPTURE(point.x(), point.y());
    if (part.norm() <= 1) {
      CHECK(surface.distance_from_floor(point) == 0);
    } else {
      CHECK(surface.distance_from_floor(point) == Approx(distance_by_search(surface, point)).margin(2e-6));
    }
  }
}

TEST_CASE("height and slope of a bowl are continuous where the wall leaves the floor") {
  for (BowlSurface surface : bowls(kCar)) {
    for (const double exponent : {1.0, 1.5, 2.0, 4.0}) {
      surface.exponent = exponent;
      for (double angle = 0; angle < 6.28; angle += 0.1) {
        const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
        double inside = 0, outside = 20;
        while (outside - inside > 1e-12) {
          const double middle = 0.5 * (inside + outside);
          (surface.distance_from_floor(middle * direction) <= 0 ? inside : outside) = middle;
        }
        const double near = 1e-9 * surface.rise_m;
        CHECK(surface.height_at((outside + near) * direction) < 2e-9 * surface.height_m + 1e-15);
        if (exponent > 1)
          CHECK(surface.normal_at((outside + near) * direction).z() == Approx(1).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("the normal of a bowl is that of its heights") {
  for (const BowlSurface& surface : bowls(kCar)) {
    for (const Eigen::Vector2d& point :
         {Eigen::Vector2d(7, 1), Eigen::Vector2d(-6, 5), Eigen::Vector2d(1, -4)}) {
      constexpr double kStep = 1e-6;
      const auto rate = [&](const Eigen::Vector2d& along) {
        return (surface.height_at(point + kStep * along) - surface.height_at(point - kStep * along)) /
               (2 * kStep);
      };
      const Eigen::Vector3d normal = surface.normal_at(point);
      CHECK(normal.norm() == Approx(1));
      CHECK(-normal.x() / normal.z() == Approx(rate({1, 0})).margin(1e-7));
      CHECK(-normal.y() / normal.z() == Approx(rate({0, 1})).margin(1e-7));
    }
  }
}

TEST_CASE("a ray meets a bowl where marching along it does, from everywhere and whatever the floor") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> across(-14, 14), up(-1, 8), turn(-1, 1);
  for (const BowlSurface& surface : bowls(kCar)) {
    int hits = 0, doubtful = 0;
    for (int i = 0; i < 2500; ++i) {
      const Eigen::Vector3d origin(across(random), across(random), up(random));
      Eigen::Vector3d direction(turn(random), turn(random), turn(random));
      if (i % 3 == 0) direction.z() *= 0.02;  // grazing
      direction.normalize();
      const Marched marched = march(surface, origin, direction);
      if (marched.doubtful) {
        ++doubtful;
        continue;
      }
      const auto hit = surface.intersect(origin, 3.5 * direction);
      CAPTURE(origin.transpose(), direction.transpose(), surface.exponent, surface.height_m);
      REQUIRE(hit.has_value() == marched.hit.has_value());
      if (!hit) continue;
      ++hits;
      CHECK((*hit - *marched.hit).norm() < 1e-6);
    }
    CHECK(hits > 150);
    CHECK(doubtful < 350);
  }
}

TEST_CASE("rays from below, over the rim and into the sky meet nothing") {
  const BowlSurface surface = default_surface(kCar);
  const double rim = surface.floor_length_m / 2 + surface.rise_m;
  CHECK_FALSE(surface.intersect({0, 0, -1}, {0, 0, 1}));
  CHECK_FALSE(surface.intersect({0, 0, -1}, {1, 0, 0.1}));
  CHECK_FALSE(surface.intersect({0, 0, 1}, {0, 0, 1}));
  CHECK_FALSE(surface.intersect({0, 0, 1}, {1, 1, 1}));
  CHECK_FALSE(
      surface.intersect({rim + 3, 0, surface.height_m / 2}, {-1, 0, 0}));  // from outside, at the wall
  CHECK_FALSE(surface.intersect({rim + 3, 0, surface.height_m + 1}, {0, 0, -1}));
  CHECK(surface.intersect({rim + 3, 0, surface.height_m + 1}, {-1, 0, -0.3}));
  CHECK(surface.intersect({0, 0, 1}, {1, 0, 0}));
}

TEST_CASE("a bowl of no height is the ground as far as the rim") {
  BowlSurface surface = default_surface(kCar);
  surface.height_m = 0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d origin(3 * turn(random), 3 * turn(random), 2);
    const Eigen::Vector3d direction(turn(random), turn(random), turn(random));
    const Eigen::Vector3d on_plane = origin - direction * (origin.z() / direction.z());
    const auto hit = surface.intersect(origin, direction);
    REQUIRE(hit.has_value() == (direction.z() < 0 && surface.inside_rim(on_plane.head<2>())));
    if (hit) CHECK((*hit - on_plane).norm() < 1e-9);
  }
}

TEST_CASE("reading a bowl allocates nothing") {
  const std::vector<BowlSurface> all = bowls(kCar);
  const size_t before = allocation_count();
  double sum = 0;
  for (const BowlSurface& surface : all) {
    for (double x = -9; x < 9; x += 0.5) {
      sum += surface.height_at({x, 3}) + surface.normal_at({x, 3}).z();
      if (const auto hit = surface.intersect({0, 0, 1}, {x, 1, -0.1})) sum += hit->z();
    }
  }
  CHECK(allocation_count() == before);
  CHECK(sum > 0);
}

TEST_CASE("all that is wrong with a bowl's parameters is told at once") {
  CHECK(check(default_surface(kToy), kToy).empty());
  CHECK(check(default_surface(kVan), kVan).empty());
  BowlSurface bad;
  bad.floor_length_m = 4;  // shorter than the car
  bad.floor_width_m = std::nan("");
  bad.rise_m = 0;
  bad.height_m = -1;
  bad.exponent = 0.5;
  const Faults faults = check(bad, kCar);
  REQUIRE(faults.size() == 5);
  const std::vector<std::string> pointers = {"/floor_length_m", "/floor_width_m", "/rise_m", "/height_m",
                                             "/exponent"};
  for (size_t i = 0; i < faults.size(); ++i) CHECK(faults[i].pointer == pointers[i]);
  CHECK_THAT(faults[0].text(), Catch::Matchers::Contains("the vehicle's 4.8"));

  BowlSurface tight = default_surface(kCar);
  tight.shape = FloorShape::kEllipse;
  tight.floor_length_m = 1.1 * kCar.length_m;
  tight.floor_width_m = 1.1 * kCar.width_m;
  REQUIRE(check(tight, kCar).size() == 1);
  CHECK(check(tight, kCar)[0].pointer == "/shape");
  tight.rise_m = std::numeric_limits<double>::infinity();
  CHECK(check(tight, kCar).size() == 2);
}
