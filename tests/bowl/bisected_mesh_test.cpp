#include "algorithms/bowl/bisected_mesh.h"

#include <cmath>
#include <map>
#include <random>

#include "algorithms/synthesis/camera_shares.h"
#include "tests/bowl/bowls.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;

namespace {

double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// A mesh with triangles cut here and there, deeper and deeper around one place.
BisectedMesh unevenly_cut(const geometry::Vehicle& vehicle, const BowlSurface& surface) {
  BisectedMesh mesh(vehicle, surface);
  std::mt19937 random(7);
  const Eigen::Vector2d place(vehicle.length_m, vehicle.width_m);
  for (size_t i = 0; i < mesh.triangles().size() && i < 6000; ++i) {
    if (mesh.triangles()[i].cut) continue;
    const auto& t = mesh.triangles()[i];
    const double size = mesh.size_m(t);
    const double near = (mesh.ground(t.corner[0]) - place).norm();
    if (size > 0.3 * near + 0.01 * vehicle.length_m || random() % 4 == 0) mesh.cut(static_cast<int>(i));
  }
  return mesh;
}

struct Border {
  double area = 0;     // of all triangles, m^2
  double sagitta = 0;  // what the rim, no sharper than a circle of radius rise_m, may have beyond its chords
};

/// Also checks that all edges but those of the rim and of the vehicle are of two triangles, in opposite
/// directions.
Border checked_border(const BisectedMesh& mesh, const geometry::Vehicle& vehicle,
                      const BowlSurface& surface) {
  Border border;
  std::map<std::pair<int, int>, int> directed;
  for (const auto& triangle : mesh.triangles()) {
    if (triangle.cut) continue;
    const auto& c = triangle.corner;
    const double twice = twice_area(mesh.ground(c[0]), mesh.ground(c[1]), mesh.ground(c[2]));
    REQUIRE(twice > 0);
    border.area += twice / 2;
    for (int i = 0; i < 3; ++i) REQUIRE(++directed[{c[i], c[(i + 1) % 3]}] == 1);
  }
  for (const auto& [edge, count] : directed) {
    if (directed.contains({edge.second, edge.first})) continue;
    const Eigen::Vector2d a = mesh.ground(edge.first), b = mesh.ground(edge.second);
    const double unit = mesh.metres_per_unit();
    const auto at_rim = [&](const Eigen::Vector2d& p) {
      return std::abs(surface.distance_from_floor(p) - surface.rise_m) < 2 * unit;
    };
    const Eigen::Vector2d half(vehicle.length_m / 2 + 2 * unit, vehicle.width_m / 2 + 2 * unit);
    const auto at_vehicle = [&](const Eigen::Vector2d& p) { return (p.array().abs() <= half.array()).all(); };
    REQUIRE(((at_rim(a) && at_rim(b)) || (at_vehicle(a) && at_vehicle(b))));
    if (at_rim(a)) border.sagitta += std::pow((a - b).norm(), 3) / (12 * surface.rise_m);
  }
  return border;
}

/// Inside the rim, from many points of it.
double rim_area(const BowlSurface& surface) {
  constexpr int kPoints = 20000;
  double twice = 0;
  Eigen::Vector2d before = surface.rim_towards({1, 0});
  for (int i = 1; i <= kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints;
    const Eigen::Vector2d next = surface.rim_towards({std::cos(angle), std::sin(angle)});
    twice += twice_area({0, 0}, before, next);
    before = next;
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("however triangles are cut, edges inside are of exactly two, and the rest is rim and vehicle") {
  for (const geometry::Vehicle& vehicle : {kToy, kCar}) {
    for (const BowlSurface& surface : bowls(vehicle)) {
      const BisectedMesh mesh = unevenly_cut(vehicle, surface);
      const Border border = checked_border(mesh, vehicle, surface);
      const double all = rim_area(surface) - vehicle.length_m * vehicle.width_m;
      const double rounding = 100 * vehicle.length_m * mesh.metres_per_unit();
      CHECK(border.area < all + rounding);
      CHECK(border.area > all - 1.1 * border.sagitta - rounding);
      CHECK(border.sagitta < 0.06 * all);
    }
  }
}

TEST_CASE("no triangle crosses an axis of the vehicle, and no corner lies under the vehicle") {
  const BisectedMesh mesh = unevenly_cut(kCar, default_surface(kCar));
  for (const auto& triangle : mesh.triangles()) {
    for (int axis = 0; axis < 2; ++axis) {
      int low = 0, high = 0;
      for (const int corner : triangle.corner) {
        low = std::min(low, mesh.places()[corner][axis]);
        high = std::max(high, mesh.places()[corner][axis]);
      }
      REQUIRE((low == 0 || high == 0));
    }
  }
  geometry::Vehicle smaller = kCar;
  smaller.length_m -= 1e-9;
  smaller.width_m -= 1e-9;
  for (size_t i = 0; i < mesh.places().size(); ++i)
    REQUIRE_FALSE(synthesis::is_under_vehicle(smaller, mesh.ground(static_cast<int>(i))));
}
