// What every lens model must do, one suite for all.

#include <chrono>
#include <cmath>
#include <functional>

#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/table_lens.h"
#include "tests/catch.h"

using namespace svchain::geometry;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A table as makers print them, of an equidistant lens with a little compression towards the rim.
LensTable printed_table(double last_deg, double printed_to_mm) {
  LensTable table;
  for (int tenths = 1; tenths <= 10 * last_deg; ++tenths) {
    const double angle_deg = 0.1 * tenths;
    const double t = radians(angle_deg);
    const double height = 1.3 * (t - 0.06 * t * t * t);
    table.angle_deg.push_back(angle_deg);
    table.height_mm.push_back(std::round(height / printed_to_mm) * printed_to_mm);
  }
  return table;
}

struct Named {
  std::string name;
  LensPtr lens;
};

std::vector<Named> all_lenses() {
  const Vector2d centre(640.3, 359.1);
  return {
      {"kannala_brandt, equidistant",
       std::make_shared<KannalaBrandt>(Vector2d(330, 330), centre, std::array{0., 0., 0., 0.})},
      {"kannala_brandt, anamorphic",
       std::make_shared<KannalaBrandt>(Vector2d(302, 320), centre,
                                       std::array{-0.0437, 0.0217, -0.0264, 0.0084})},
      {"kannala_brandt, turning at 87 degrees",
       std::make_shared<KannalaBrandt>(Vector2d(303, 322), centre,
                                       std::array{-0.0355, -0.0198, 0.0261, -0.0097})},
      {"kannala_brandt, 250 degrees wide",
       std::make_shared<KannalaBrandt>(Vector2d(200, 200), centre, std::array{-0.01, 0., 0., 0.},
                                       radians(125))},
      {"table, exact", std::make_shared<TableLens>(printed_table(100, 1e-9), 4.2, centre)},
      {"table, printed to 0.01 mm", std::make_shared<TableLens>(printed_table(100, 1e-2), 4.2, centre)},
      {"table, ending at 60 degrees", std::make_shared<TableLens>(printed_table(60, 1e-3), 4.2, centre)},
  };
}

Vector3d ray(double angle, double azimuth) {
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

void for_all_lenses(const std::function<void(const Lens&)>& check) {
  for (const auto& [name, lens] : all_lenses()) {
    INFO(name);
    check(*lens);
  }
}

/// Rays from the axis to the very rim, all around.
void for_all_rays(const Lens& lens, const std::function<void(const Vector3d&)>& check) {
  for (int i = 0; i <= 100; ++i) {
    for (int j = 0; j < 16; ++j) check(ray(lens.max_angle_rad() * i / 100, 2 * kPi * j / 16));
  }
}

}  // namespace

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

TEST_CASE("every lens keeps the direction of a ray around its axis") {
  for_all_lenses([](const Lens& lens) {
    const Vector2d centre = *lens.project(Vector3d::UnitZ());
    for (int j = 0; j < 32; ++j) {
      const double azimuth = 2 * kPi * j / 32;
      const Vector2d a = *lens.project(ray(0.4, azimuth)) - centre;
      const Vector2d b = *lens.project(ray(0.8, azimuth)) - centre;
      CHECK(a.normalized().dot(b.normalized()) == Approx(1).epsilon(1e-12));
      const Vector2d opposite = *lens.project(ray(0.4, azimuth + kPi)) - centre;
      CHECK((a + opposite).norm() < 1e-9);
    }
  });
}

TEST_CASE("every lens images angles in rising order and without a leap") {
  for_all_lenses([](const Lens& lens) {
    const Vector2d centre = *lens.project(Vector3d::UnitZ());
    constexpr int kSteps = 20000;
    double last = 0;
    double largest_step = 0;
    bool rises = true;
    for (int i = 1; i <= kSteps; ++i) {
      const double r = (*lens.project(ray(lens.max_angle_rad() * i / kSteps, 0.3)) - centre).norm();
      rises = rises && r > last;
      largest_step = std::max(largest_step, r - last);
      last = r;
    }
    CHECK(rises);
    CHECK(largest_step < 5 * last / kSteps);
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
