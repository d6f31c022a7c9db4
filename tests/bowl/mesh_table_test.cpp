#include "algorithms/bowl/mesh_table.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>

#include "algorithms/bowl/pair_sights.h"
#include "algorithms/synthesis/camera_shares.h"
#include "tests/allocation_count.h"
#include "tests/bowl/bowls.h"
#include "tests/bowl/mesh_accuracy.h"
#include "tests/bowl/owned_mesh.h"
#include "tests/bowl/triangle_cover.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

using Position = std::array<int16_t, 3>;

geometry::Rig rig_file(const std::string& name) {
  auto rig = geometry::read_rig(project_folder() / "configs" / "rigs" / (name + ".json"));
  REQUIRE(rig);
  return *rig;
}

BowlSurface ellipse_for(const geometry::Rig& rig) {
  BowlSurface surface = default_surface(rig.vehicle);
  surface.shape = FloorShape::kEllipse;
  return surface;
}

/// Pictures end on its wall, the one above the other.
BowlSurface high_for(const geometry::Rig& rig) {
  BowlSurface surface = default_surface(rig.vehicle);
  surface.height_m = rig.vehicle.length_m;
  return surface;
}

/// Whether every point about this one, inside the rim and beside the vehicle, is seen.
bool is_seen_around(const PairSights& sights, const geometry::Rig& rig, const BowlSurface& surface,
                    const Eigen::Vector2d& ground, double radius) {
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * M_PI * i / 16;
    const Eigen::Vector2d p = ground + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    if (!surface.inside_rim(p) || synthesis::is_under_vehicle(rig.vehicle, p)) return false;
    if (!sights.at(pair_at(p), p).shown()) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a mesh table's triangles meet in whole edges of exactly equal positions") {
  const geometry::Rig rig = four_cameras();
  for (const BowlSurface& surface : {default_surface(rig.vehicle), ellipse_for(rig), high_for(rig)}) {
    const OwnedMesh mesh(rig, surface);
    const MeshTable table = mesh.table();
    std::map<std::pair<Position, Position>, int> directed;
    std::set<Position> positions;
    for (size_t t = 0; t < table.indices().size(); t += 3) {
      for (size_t i = 0; i < 3; ++i) {
        const Position& a = table.vertices()[table.indices()[t + i]].position;
        const Position& b = table.vertices()[table.indices()[t + (i + 1) % 3]].position;
        REQUIRE(++directed[{a, b}] == 1);  // the other triangle has it in the other direction
        positions.insert(a);
      }
    }
    // Where an edge has one triangle, no other vertex lies on it: what is beyond is left out, not cut finer.
    size_t alone = 0;
    for (const auto& [edge, count] : directed) {
      if (directed.contains({edge.second, edge.first})) continue;
      ++alone;
      const Eigen::Vector2d a(edge.first[0], edge.first[1]), b(edge.second[0], edge.second[1]);
      for (const Position& position : positions) {
        if (position == edge.first || position == edge.second) continue;
        const Eigen::Vector2d p(position[0], position[1]);
        const double along = (p - a).dot(b - a) / (b - a).squaredNorm();
        if (along <= 0 || along >= 1) continue;
        REQUIRE((p - a - along * (b - a)).norm() > 2);
      }
    }
    CHECK(alone < directed.size() / 15);
  }
}

TEST_CASE("a mesh table covers once what the cameras see around the vehicle, and never lies over itself") {
  for (const char* name : {"car", "toy", "garage"}) {
    const geometry::Rig rig = rig_file(name);
    for (const BowlSurface& surface : {default_surface(rig.vehicle), ellipse_for(rig), high_for(rig)}) {
      const OwnedMesh mesh(rig, surface);
      const TriangleCover cover(mesh.table());
      const PairSights sights(rig, surface, {});
      std::mt19937 random(1);
      std::uniform_real_distribution<double> unit(-1, 1);
      int seen = 0, once = 0;
      for (int i = 0; i < 4000; ++i) {
        const Eigen::Vector2d ground(unit(random) * (surface.floor_length_m / 2 + surface.rise_m),
                                     unit(random) * (surface.floor_width_m / 2 + surface.rise_m));
        const int count = cover.count(ground);
        REQUIRE(count <= 1);
        if (!is_seen_around(sights, rig, surface, ground, 0.02 * rig.vehicle.length_m)) continue;
        ++seen;
        once += count;
      }
      CAPTURE(name, once, seen);
      CHECK(seen > 2500);
      CHECK(seen == once);
      const double all =
          (surface.floor_length_m + 2 * surface.rise_m) * (surface.floor_width_m + 2 * surface.rise_m);
      CHECK(cover.area_m2() < all);
      CHECK(cover.area_m2() > 0.6 * all);
    }
  }
}

TEST_CASE("interpolated texture coordinates stay within the tolerance, and weights within a few 255ths") {
  for (const char* name : {"car", "toy"}) {
    const geometry::Rig rig = rig_file(name);
    for (const BowlSurface& surface : {default_surface(rig.vehicle), high_for(rig)}) {
      for (const double tolerance_px : {0.75, 3.0}) {
        const OwnedMesh mesh(rig, surface, {}, tolerance_px);
        const MeshAccuracy accuracy =
            measure_accuracy(mesh.table(), rig, surface, {}, 5, rig.vehicle.length_m / 40, 1);
        CAPTURE(name, surface.height_m, tolerance_px, accuracy.vertices);
        CHECK(accuracy.worst_px < tolerance_px);
        CHECK(accuracy.mean_px < tolerance_px / 3);
        CHECK(accuracy.worst_weight < kWeightOff);
        CHECK(accuracy.mean_weight < 1);
        CHECK(accuracy.weights_off < accuracy.points / 100);
        CHECK(accuracy.points > 3 * accuracy.triangles);
      }
    }
  }
}

TEST_CASE("a mesh table at the default tolerance has fewer vertices than a grid of 100 x 100") {
  for (const char* name : {"car", "toy", "garage"}) {
    const geometry::Rig rig = rig_file(name);
    CHECK(OwnedMesh(rig, default_surface(rig.vehicle)).table().vertices().size() < 10000);
  }
}

TEST_CASE("every vertex is seen by all cameras of its batch, where its texture coordinates say") {
  for (const char* name : {"car", "garage"}) {
    const geometry::Rig rig = rig_file(name);
    const BowlSurface surface = default_surface(rig.vehicle);
    const OwnedMesh mesh(rig, surface);
    const MeshTable table = mesh.table();
    for (const MeshVertex& vertex : table.vertices()) {
      const MeshBatch& batch = table.batches()[vertex.batch];
      const Eigen::Vector3d position = table.position(vertex);
      const Eigen::Vector2d ground = position.head<2>();
      REQUIRE(std::abs(position.z() - surface.height_at(ground)) <= 0.51 * table.header().metres_per_unit);
      for (int which = 0; which < 2; ++which) {
        const auto& camera = rig.cameras[which == 0 ? batch.first : batch.second];
        const auto pixel = camera.see({ground.x(), ground.y(), surface.height_at(ground)});
        REQUIRE(pixel);
        REQUIRE((table.pixel(vertex, which) - *pixel).norm() < 0.02);
      }
    }
  }
}

TEST_CASE("batches are of neighbours or of one camera, and no weight steps where one meets the other") {
  const geometry::Rig rig = rig_file("car");
  const OwnedMesh mesh(rig, default_surface(rig.vehicle));
  const MeshTable table = mesh.table();
  CHECK(table.batches().size() == 8);
  std::map<std::pair<Position, uint32_t>, int> alone;
  for (const MeshBatch& batch : table.batches()) {
    CHECK((batch.second == batch.first || batch.second == (batch.first + 1) % 4));
    if (batch.first != batch.second) continue;
    for (const MeshVertex& v : table.vertices().subspan(batch.first_vertex, batch.vertex_count)) {
      REQUIRE(v.first_weight == 255);
      alone[{v.position, batch.first}] = 1;
    }
  }
  int met = 0;
  for (const MeshVertex& v : table.vertices()) {
    const MeshBatch& batch = table.batches()[v.batch];
    // On the axes another pair of cameras begins.
    if (batch.first == batch.second || v.position[0] == 0 || v.position[1] == 0) continue;
    if (alone.contains({v.position, batch.first})) REQUIRE(v.first_weight == 255);
    if (alone.contains({v.position, batch.second})) REQUIRE(v.first_weight == 0);
    met += v.first_weight == 0 || v.first_weight == 255;
  }
  CHECK(met > 100);
}

TEST_CASE("a mesh is denser where the lens bends, near the cameras") {
  const geometry::Rig rig = four_cameras();
  const BowlSurface surface = default_surface(rig.vehicle);
  const OwnedMesh mesh(rig, surface, {0, synthesis::BlendCurve::kSmooth});
  const MeshTable table = mesh.table();
  size_t near = 0;
  for (const MeshVertex& v : table.vertices())
    near += surface.distance_from_floor(table.position(v).head<2>()) <= 0;
  const double floor = surface.floor_length_m * surface.floor_width_m;
  const double all =
      (surface.floor_length_m + 2 * surface.rise_m) * (surface.floor_width_m + 2 * surface.rise_m);
  CHECK(double(near) / double(table.vertices().size()) > 2 * floor / all);
}

TEST_CASE("a mesh table is the same bytes every time it is made, and is read in place without allocating") {
  const geometry::Rig rig = four_cameras({640, 360});
  const BowlSurface surface = default_surface(rig.vehicle);
  const OwnedMesh mesh(rig, surface), again(rig, surface);
  CHECK(mesh.memory() == again.memory());
  const MeshTable table = mesh.table();
  const size_t before = allocation_count();
  double sum = 0;
  for (const MeshBatch& batch : table.batches())
    for (const uint16_t index : table.indices(batch)) sum += table.pixel(table.vertices()[index], 0).x();
  CHECK(allocation_count() == before);
  CHECK(sum > 0);
}

TEST_CASE("what a mesh table cannot be built from is named") {
  geometry::Rig rig = four_cameras();
  BowlSurface surface = default_surface(rig.vehicle);
  std::vector<std::byte> memory(mesh_table_capacity());
  const auto build = [&](double width_deg, double tolerance_px, size_t bytes) {
    return build_mesh_table(rig, surface, {width_deg, synthesis::BlendCurve::kSmooth}, tolerance_px,
                            std::span(memory).first(bytes));
  };
  CHECK_THROWS_WITH(build(100, 1, memory.size()), Contains("blend is 100"));
  CHECK_THROWS_WITH(build(60, 0, memory.size()), Contains("tolerance is 0"));
  CHECK_THROWS_WITH(build(60, 3, 10000), Contains("memory has only 10000"));
  surface.rise_m = -1;
  surface.exponent = 0;
  CHECK_THROWS_WITH(build(60, 1, memory.size()), Contains("rise_m") && Contains("exponent"));
  rig.cameras.pop_back();
  CHECK_THROWS_WITH(build(60, 1, memory.size()), Contains("expected four cameras, got 3"));
}

TEST_CASE("memory that holds no whole mesh table is refused") {
  const geometry::Rig rig = four_cameras({640, 360});
  const OwnedMesh mesh(rig, default_surface(rig.vehicle), {}, 3);
  std::vector<std::byte> bytes = mesh.memory();
  const auto read = [&] { MeshTable table{std::span<const std::byte>(bytes)}; };
  CHECK_NOTHROW(read());
  bytes.resize(bytes.size() - 1);
  CHECK_THROWS_WITH(read(), Contains("the memory has only"));
  bytes.resize(100);
  CHECK_THROWS_WITH(read(), Contains("shorter than its header"));
  bytes = mesh.memory();
  bytes[4] = std::byte{9};
  CHECK_THROWS_WITH(read(), Contains("version 9, expected 1"));
  bytes[0] = std::byte{0};
  CHECK_THROWS_WITH(read(), Contains("holds none"));
}

TEST_CASE("a damaged mesh table is refused, or is one that can be read without leaving its memory") {
  const geometry::Rig rig = four_cameras({640, 360});
  const OwnedMesh mesh(rig, default_surface(rig.vehicle), {}, 3);
  std::mt19937 random(2);
  int refused = 0, read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::byte> bytes = mesh.memory();
    const size_t last = i % 2 ? sizeof(MeshHeader) : bytes.size();
    for (int flips = 0; flips < 3; ++flips) bytes[random() % last] ^= std::byte(1 << random() % 8);
    try {
      const MeshTable table{std::span<const std::byte>(bytes)};
      double sum = 0;
      for (const MeshBatch& batch : table.batches()) {
        for (const uint16_t index : table.indices(batch)) {
          REQUIRE(index < table.vertices().size());
          sum += table.pixel(table.vertices()[index], 1).y() + table.position(table.vertices()[index]).x();
        }
      }
      ++read;
      REQUIRE(!std::isnan(sum));
    } catch (const std::invalid_argument& error) {
      REQUIRE_THAT(error.what(), Contains("mesh table: "));
      ++refused;
    }
  }
  CHECK(refused > 1000);
  CHECK(read > 100);
}
