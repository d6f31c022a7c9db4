#include "algorithms/calibration/corner_pattern.h"

#include <cmath>

#include "tests/catch.h"

using namespace svchain::calibration;
using Eigen::Vector2d;

namespace {

constexpr DarkQuarters kKinds[] = {0b0101, 0b1010, 0b0001, 0b1000, 0b0111, 0b1110};

/// Edges at 35 degrees to each other, shaded.
CornerShape slanted_shape() {
  return {{0.3, -0.2}, {0.4, 0.4 + 2.53}, std::log(0.8), 200, 150, {0.003, -0.002}};
}

/// The same brightness, by adding up light within the blur's reach.
double brute_force(const CornerShape& shape, DarkQuarters dark, const Vector2d& place) {
  constexpr double kStep = 0.02;
  const double blur = shape.blur_px();
  const Vector2d x(std::cos(shape.normals_rad.x()), std::sin(shape.normals_rad.x()));
  const Vector2d y(std::cos(shape.normals_rad.y()), std::sin(shape.normals_rad.y()));
  double sum = 0, weights = 0;
  for (double v = -5 + kStep / 2; v < 5; v += kStep) {
    for (double u = -5 + kStep / 2; u < 5; u += kStep) {
      const Vector2d off = place + blur * Vector2d(u, v) - shape.corner_px;
      const int quarter = y.dot(off) > 0 ? (x.dot(off) > 0 ? 0 : 1) : (x.dot(off) > 0 ? 3 : 2);
      const double weight = std::exp(-0.5 * (u * u + v * v));
      sum += weight * (dark >> quarter & 1);
      weights += weight;
    }
  }
  const double shade = 1 + shape.shading_per_px.dot(place);
  return shade * (shape.light - shape.contrast * sum / weights);
}

}  // namespace

TEST_CASE("a corner's pattern is its quarters blurred, however slanted they are") {
  for (const auto dark : kKinds) {
    const CornerPattern pattern(slanted_shape(), dark);
    for (const Vector2d& place :
         {Vector2d(0.3, -0.2), Vector2d(1, 0.2), Vector2d(-0.6, -0.8), Vector2d(0, 2)}) {
      CAPTURE(int(dark), place.transpose());
      CHECK(pattern.at(place).grey == Approx(brute_force(slanted_shape(), dark, place)).margin(0.1));
    }
  }
}

TEST_CASE("a corner's pattern knows how it changes with each of its numbers") {
  constexpr double kDelta = 1e-5;
  for (const auto dark : kKinds) {
    for (const Vector2d& place : {Vector2d(0.5, 0.1), Vector2d(-0.6, -0.8), Vector2d(0.4, 1.2)}) {
      const auto gradient = CornerPattern(slanted_shape(), dark).at(place).gradient;
      for (int i = 0; i < CornerShape::kCount; ++i) {
        const CornerShape::Vector step = kDelta * CornerShape::Vector::Unit(i);
        const double after = CornerPattern(slanted_shape().moved(step), dark).at(place).grey;
        const double before = CornerPattern(slanted_shape().moved(-step), dark).at(place).grey;
        CAPTURE(int(dark), place.transpose(), i);
        CHECK(gradient[i] == Approx((after - before) / (2 * kDelta)).epsilon(1e-5).margin(1e-4));
      }
    }
  }
}

TEST_CASE("two neighbouring dark quarters, all and none have no corner") {
  for (const auto dark : kKinds) CHECK(CornerPattern::is_corner(dark));
  for (const DarkQuarters dark : {0b0000, 0b0011, 0b0110, 0b1100, 0b1001, 0b1111}) {
    CHECK_FALSE(CornerPattern::is_corner(dark));
  }
}
