// What every lens model must do, one suite for all.

#include <cmath>
#include <limits>

#include "tests/geometry/all_lenses.h"

using namespace svchain::geometry;
using namespace svchain::testing;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST_CASE("every lens finds a pixel's ray back, from the axis to the rim, within a millionth of a pixel") {
  for_all_lenses([](const Lens& lens) {
    double worst_px = 0;
    for_all_rays(lens, [&](const Vector3d& r) {
      const auto pixel = lens.project(r);
      REQUIRE(pixel);
      const auto back = lens.unproject(*pixel);
      REQUIRE(back);
      const auto again = lens.project(*back);
      REQUIRE(again);
      worst_px = std::max(worst_px, (*again - *pixel).norm());
    });
    CHECK(worst_px < 1e-6);
  });
}

TEST_CASE("every lens returns unit rays, and the one that was projected") {
  for_all_lenses([](const Lens& lens) {
    double worst = 0;
    double worst_norm = 0;
    for_all_rays(lens, [&](const Vector3d& r) {
      const auto back = lens.unproject(*lens.project(r));
      REQUIRE(back);
      worst_norm = std::max(worst_norm, std::abs(back->norm() - 1));
      // At a turning point the height hardly tells angles apart; inside, it must.
      if (std::acos(std::min(1.0, r.z())) < 0.98 * lens.max_angle_rad())
        worst = std::max(worst, (*back - r).norm());
    });
    CHECK(worst_norm < 1e-12);
    CHECK(worst < 1e-9);
  });
}

TEST_CASE("every lens projects a ray of any length to the same pixel") {
  for_all_lenses([](const Lens& lens) {
    const auto near = lens.project(1e-3 * ray(0.9, 0.7));
    const auto far = lens.project(1e6 * ray(0.9, 0.7));
    REQUIRE(near);
    REQUIRE(far);
    CHECK((*near - *far).norm() < 1e-9);
  });
}

TEST_CASE("every lens sees the axis at its centre and nothing straight behind") {
  for_all_lenses([](const Lens& lens) {
    const auto centre = lens.project(Vector3d::UnitZ());
    REQUIRE(centre);
    CHECK((*centre - Vector2d(640.3, 359.1)).norm() < 1e-12);
    CHECK((*lens.unproject(*centre) - Vector3d::UnitZ()).norm() < 1e-12);
    CHECK_FALSE(lens.project(-Vector3d::UnitZ()));
  });
}

TEST_CASE("no lens projects a zero ray or one that is no number") {
  for_all_lenses([](const Lens& lens) {
    CHECK_FALSE(lens.project(Vector3d::Zero()));
    CHECK_FALSE(lens.project(Vector3d::Constant(std::nan(""))));
    CHECK_FALSE(lens.unproject(Vector2d::Constant(std::nan(""))));
  });
}

TEST_CASE("no lens sees beyond its largest angle, in either direction") {
  for_all_lenses([](const Lens& lens) {
    for (const double azimuth : {0.0, 1.0, 3.0, 5.5}) {
      CHECK(lens.project(ray(lens.max_angle_rad() - 1e-6, azimuth)));
      CHECK_FALSE(lens.project(ray(lens.max_angle_rad() + 1e-6, azimuth)));
      const Vector2d rim = *lens.project(ray(lens.max_angle_rad(), azimuth));
      const Vector2d centre = *lens.project(Vector3d::UnitZ());
      CHECK_FALSE(lens.unproject(rim + 1e-3 * (rim - centre).normalized()));
      CHECK_FALSE(lens.unproject(centre + 100 * (rim - centre)));
    }
  });
}

TEST_CASE("every lens without tangential distortion keeps the direction of a ray around its axis") {
  for (const auto& named : all_lenses()) {
    if (!named.keeps_direction) continue;
    INFO(named.name);
    const Lens& lens = *named.lens;
    const Vector2d centre = *lens.project(Vector3d::UnitZ());
    for (int j = 0; j < 32; ++j) {
      const double azimuth = 2 * kPi * j / 32;
      const Vector2d a = *lens.project(ray(0.4, azimuth)) - centre;
      const Vector2d b = *lens.project(ray(0.8, azimuth)) - centre;
      CHECK(a.normalized().dot(b.normalized()) == Approx(1).epsilon(1e-12));
      const Vector2d opposite = *lens.project(ray(0.4, azimuth + kPi)) - centre;
      CHECK((a + opposite).norm() < 1e-9);
    }
  }
}

TEST_CASE("every lens images angles in rising order and without a leap") {
  for_all_lenses([](const Lens& lens) {
    const Vector2d centre = *lens.project(Vector3d::UnitZ());
    constexpr int kSteps = 20000;
    double last = 0;
    double step = std::numeric_limits<double>::infinity();
    double steepening =
        0;  // one step over the one before: a steep lens keeps near 1, a leap is many times that
    bool rises = true;
    for (int i = 1; i <= kSteps; ++i) {
      const double r = (*lens.project(ray(lens.max_angle_rad() * i / kSteps, 0.3)) - centre).norm();
      rises = rises && r > last;
      steepening = std::max(steepening, (r - last) / step);
      step = r - last;
      last = r;
    }
    CHECK(rises);
    CHECK(steepening < 2);
  });
}

TEST_CASE("a Kannala-Brandt lens follows its formula at and beyond 90 degrees") {
  const KannalaBrandt lens({300, 310}, {640, 360}, {0.01, -0.002, 0.001, -0.0001}, radians(110));
  for (const double degrees_off : {10.0, 90.0, 105.0}) {
    const double t = radians(degrees_off);
    const double r =
        t + 0.01 * std::pow(t, 3) - 0.002 * std::pow(t, 5) + 0.001 * std::pow(t, 7) - 0.0001 * std::pow(t, 9);
    const auto pixel = lens.project(ray(t, 0.6));
    REQUIRE(pixel);
    CHECK(pixel->x() == Approx(640 + 300 * r * std::cos(0.6)));
    CHECK(pixel->y() == Approx(360 + 310 * r * std::sin(0.6)));
  }
}

TEST_CASE("a Kannala-Brandt lens is used up to 95 degrees, or less where its height stops rising") {
  CHECK(KannalaBrandt({300, 300}, {0, 0}, {0, 0, 0, 0}).max_angle_rad() == radians(95));
  // r = t - t^3/3 has its only turning point at t = 1.
  CHECK(KannalaBrandt({300, 300}, {0, 0}, {-1.0 / 3, 0, 0, 0}).max_angle_rad() == Approx(1));
  CHECK(KannalaBrandt({300, 300}, {0, 0}, {-1.0 / 3, 0, 0, 0}, 0.5).max_angle_rad() == 0.5);
}

namespace {

/// A point well off the axis, seen by lenses with round parameters; where it must land was worked out apart
/// from this code, by the published formulas in Cartesian coordinates.
const Vector3d kPoint(0.8, -0.3, 0.5);

void check_lands(const Lens& lens, const Vector3d& point, const Vector2d& expected_px) {
  const auto pixel = lens.project(point);
  REQUIRE(pixel);
  CHECK((*pixel - expected_px).norm() < 1e-9);
}

}  // namespace

TEST_CASE("the sphere models put a point where their papers' formulas do") {
  check_lands(Mei(1.4, {700, 710}, {640, 360}, {-0.2, 0.05, 1e-3, -2e-3}), kPoint,
              {924.4867186841, 251.8298754429});
  check_lands(DoubleSphere({-0.18, 0.59}, {340, 340}, {640, 360}), kPoint, {1045.6013716888, 207.8994856167});
  check_lands(Eucm({0.61, 1.07}, {340, 340}, {640, 360}), kPoint, {973.9829320888, 234.7564004667});
}

TEST_CASE("the sphere models at their simplest are a pinhole") {
  const Vector3d near_axis(0.5, -0.25, 1);
  const Vector2d expected_px(640 + 150, 360 - 75);
  check_lands(Mei(0, {300, 300}, {640, 360}, {0, 0, 0, 0}), near_axis, expected_px);
  check_lands(DoubleSphere({0, 0}, {300, 300}, {640, 360}), near_axis, expected_px);
  check_lands(Eucm({0, 1}, {300, 300}, {640, 360}), near_axis, expected_px);
  check_lands(Pinhole({300, 300}, {640, 360}, {0, 0, 0, 0, 0}), near_axis, expected_px);
}

TEST_CASE("a pinhole with five coefficients distorts as OpenCV's does") {
  check_lands(Pinhole({300, 310}, {640, 360}, {-0.3, 0.1, 1e-3, -2e-3, -0.012}), {0.5, -0.25, 1},
              {776.7849121094, 289.3277954102});
}

TEST_CASE("a polynomial lens follows its formula, the aspect on its rows") {
  check_lands(Polynomial({{339.749, -31.988, 48.275, -7.201}}, {1, 1.02}, {640, 360}), kPoint,
              {981.8973660291, 229.2242574939});
}

TEST_CASE("an OCam lens counts theta from across the axis, rows before columns") {
  check_lands(Ocam({502, 318, -4, 1.5}, {1.001, 0.002, -0.003}, {360, 640}), kPoint,
              {951.4776267725, 243.8327292834});
}

TEST_CASE("an OCam polynomial that misses the axis by a pixel still takes every pixel for a ray") {
  for (const double miss_px : {-1.0, 1.0}) {
    INFO(miss_px);
    const Ocam lens({320 * kPi / 2 + miss_px, 320}, {1, 0, 0}, {360, 640});
    for (const double off_px : {0.5, 1.5, 40.0}) {
      const auto there = lens.unproject({640 + off_px, 360});
      REQUIRE(there);
      CHECK(there->z() > 0);
      if (off_px > 1) CHECK((*lens.project(*there) - Vector2d(640 + off_px, 360)).norm() < 1e-6);
    }
  }
}

TEST_CASE("every model stops where its picture would fold or run away") {
  // A pinhole at 80 degrees, whatever is asked for.
  CHECK(Pinhole({300, 300}, {0, 0}, {0, 0, 0, 0, 0}, radians(95)).max_angle_rad() == radians(80));
  // x (1 - x^2 / 3) turns at x = 1, which is 45 degrees.
  CHECK(Pinhole({300, 300}, {0, 0}, {-1. / 3, 0, 0, 0, 0}).max_angle_rad() == Approx(kPi / 4));
  // Seen from xi > 1 the sphere's picture turns where cos t = -1 / xi.
  CHECK(Mei(2, {700, 700}, {0, 0}, {0, 0, 0, 0}, radians(180)).max_angle_rad() == Approx(radians(120)));
  // With beta 1 the enhanced model turns where cos t = -(1 - alpha) / alpha.
  CHECK(Eucm({2. / 3, 1}, {300, 300}, {0, 0}, radians(180)).max_angle_rad() == Approx(radians(120)));
  // 300 t - 150 t^2 turns at t = 1.
  CHECK(Polynomial({{300, -150, 0, 0}}, {1, 1}, {0, 0}).max_angle_rad() == Approx(1));
  // Below a half there is no turning, but a flight to infinity.
  const DoubleSphere running({0, 0.2}, {300, 300}, {0, 0}, radians(180));
  CHECK(running.max_angle_rad() < std::acos(-0.25));
  CHECK(running.project(ray(running.max_angle_rad(), 0))->x() < 300 / 0.17);
}
