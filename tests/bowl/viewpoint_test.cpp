#include "algorithms/bowl/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/bowl/viewpoint_presets.h"
#include "tests/bowl/bowls.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const Eigen::Vector2i kSize = {880, 1080};

std::string faults_text(const Viewpoint& viewpoint) {
  std::string text;
  for (const Fault& fault : check(viewpoint, kCar, default_surface(kCar))) text += fault.text() + "\n";
  return text;
}

}  // namespace

TEST_CASE("the ray through a pixel leads to the points that are projected onto it") {
  const Viewpoint viewpoint = *preset("chase", kCar, default_surface(kCar));
  const Perspective perspective(viewpoint, kSize);
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(879, 1079), Eigen::Vector2d(300.25, 7)}) {
    const auto seen = perspective.project(perspective.eye() + 7.5 * perspective.ray(pixel));
    REQUIRE(seen);
    CHECK((*seen - pixel).norm() < 1e-9);
  }
  CHECK_FALSE(perspective.project(perspective.eye() - perspective.ray({400, 500})));
  const auto target = perspective.project(viewpoint.target_m);
  REQUIRE(target);
  CHECK((*target - Eigen::Vector2d(439.5, 539.5)).norm() < 1e-9);
  // Half the field of view lies between the middle and the upper edge, half a pixel above the first row.
  const double cosine =
      perspective.ray({439.5, 539.5}).normalized().dot(perspective.ray({439.5, -0.5}).normalized());
  CHECK(std::acos(cosine) * 360 / M_PI == Approx(viewpoint.field_of_view_deg));
}

TEST_CASE("a picture is upright, and left is left") {
  const Perspective chase(*preset("chase", kCar, default_surface(kCar)), kSize);
  CHECK(chase.project({0, 1, 0})->x() < chase.project({0, -1, 0})->x());
  CHECK(chase.project({0, 0, 1})->y() < chase.project({0, 0, 0})->y());
  const Perspective top(*preset("top", kCar, default_surface(kCar)), kSize);
  CHECK(top.project({2, 0, 0})->y() < top.project({-2, 0, 0})->y());
  CHECK(top.project({0, 1, 0})->x() < top.project({0, -1, 0})->x());
  CHECK(chase.vehicle_from_picture().determinant() == Approx(1));
}

TEST_CASE(
    "every preset looks at the vehicle and is free of faults, for a toy, a car and a van in every bowl") {
  for (const geometry::Vehicle& vehicle : {kToy, kCar, kVan}) {
    for (const BowlSurface& surface : bowls(vehicle)) {
      for (const std::string& name : preset_names()) {
        CAPTURE(name, vehicle.length_m, surface.exponent);
        const auto viewpoint = preset(name, vehicle, surface);
        REQUIRE(viewpoint);
        CHECK(check(*viewpoint, vehicle, surface).empty());
        CHECK(is_in_body(vehicle, viewpoint->target_m));
        // Near a wheel not all of it is in the picture, nor where a steep wall keeps the eye near.
        const bool close = name.starts_with("wheel") || surface.exponent == 1;
        const Perspective picture(*viewpoint, kSize);
        int corners = 0;
        for (int i = 0; i < 4; ++i) {
          const auto at = picture.project(
              {(i < 2 ? 0.5 : -0.5) * vehicle.length_m, (i % 2 ? 0.5 : -0.5) * vehicle.width_m, 0});
          corners += at && at->minCoeff() > 0 && at->x() < kSize.x() - 1 && at->y() < kSize.y() - 1;
        }
        CHECK(corners >= (close ? 1 : 4));
      }
    }
  }
  CHECK_FALSE(preset("botom", kCar, default_surface(kCar)));
}

TEST_CASE("a preset whose eye would be in the bowl's wall is moved in front of it") {
  BowlSurface narrow = default_surface(kCar);
  narrow.floor_length_m = 1.5 * kCar.length_m;
  narrow.floor_width_m = 2.5 * kCar.width_m;
  narrow.rise_m = 1;
  narrow.height_m = 6;
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(check(*preset(name, kCar, narrow), kCar, narrow).empty());
  }
  CHECK(preset("chase", kCar, narrow)->eye_m.x() > preset("chase", kCar, default_surface(kCar))->eye_m.x());
}

TEST_CASE("all that is wrong with a viewpoint is told at once") {
  Viewpoint bad;
  bad.eye_m = {0, 0, std::nan("")};
  bad.target_m = {0, std::numeric_limits<double>::infinity(), 0};
  bad.up = {0, 0, 0};
  bad.field_of_view_deg = 170;
  const std::string text = faults_text(bad);
  CHECK(std::count(text.begin(), text.end(), '\n') == 4);
  CHECK_THAT(text, Contains("/eye_m: expected three numbers, got 0, 0, nan"));
  CHECK_THAT(text, Contains("/target_m") && Contains("/up: has no direction"));
  CHECK_THAT(text, Contains("/field_of_view_deg: expected 1 to 150 degrees, got 170"));
}

TEST_CASE("an eye in the vehicle, in the ground, in the bowl's wall or on its target is refused") {
  const Viewpoint good = {{-8, 0, 4}, {0, 0, 0}, {0, 0, 1}, 60};
  CHECK(faults_text(good) == "");
  Viewpoint bad = good;
  bad.eye_m = {1, 0.5, 1};
  CHECK_THAT(faults_text(bad), Contains("inside the vehicle, expected it outside its box of 4.8"));
  bad.eye_m = {1, 2.5, -0.1};
  CHECK_THAT(faults_text(bad), Contains("not above the ground"));
  bad.eye_m = {9, 0, 0.5};
  CHECK_THAT(faults_text(bad), Contains("below the bowl"));
  bad.eye_m = {30, 0, 2};  // beyond the rim and lower
  CHECK_THAT(faults_text(bad), Contains("below the bowl, expected it above 2.4"));
  bad.eye_m = {30, 0, 3};
  CHECK(faults_text(bad) == "");
  bad = good;
  bad.target_m = bad.eye_m;
  CHECK_THAT(faults_text(bad), Contains("/target_m: is where the eye is"));
  bad = good;
  bad.eye_m = {0, 0, 9};
  CHECK_THAT(faults_text(bad), Contains("/up: points along the sight"));
  bad.up = {1, 0, 0};
  CHECK(faults_text(bad) == "");
}
