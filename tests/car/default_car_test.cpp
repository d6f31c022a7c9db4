#include "algorithms/car/default_car.h"

#include <algorithm>

#include "algorithms/car/car_picture.h"
#include "tests/car/look_at.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::car;

namespace {

const std::vector<geometry::Vehicle> kVehicles = {{0.4, 0.19}, {4.8, 1.9}, {5.9, 2.0}};

const Part& part(const CarModel& model, const std::string& name) {
  const auto found =
      std::ranges::find_if(model.parts, [&](const Part& p) { return p.material.name == name; });
  REQUIRE(found != model.parts.end());
  return *found;
}

/// Within the length and the middle of the car's mirrors: only there may it be wider than the vehicle.
bool at_a_mirror(const Eigen::Vector3f& p, const geometry::Vehicle& vehicle) {
  const auto length = static_cast<float>(vehicle.length_m);
  return p.x() > 0.12f * length && p.x() < 0.18f * length && p.z() > 0.19f * length;
}

}  // namespace

TEST_CASE("the default car fits into a toy's, a car's and a van's rectangle but for its mirrors") {
  for (const geometry::Vehicle& vehicle : kVehicles) {
    const CarModel model = default_car(vehicle);
    const auto length = static_cast<float>(vehicle.length_m), width = static_cast<float>(vehicle.width_m);
    size_t outside = 0;
    for (const Vertex& v : model.vertices)
      outside += std::abs(v.position.x()) > 0.502f * length ||
                 (std::abs(v.position.y()) > 0.501f * width && !at_a_mirror(v.position, vehicle));
    CHECK(outside == 0);
    const Eigen::AlignedBox3f box = bounding_box(model);
    CHECK(box.sizes().x() > 0.99f * length);
    CHECK(box.sizes().y() < 1.2f * width);
    CHECK(box.max().z() == Approx(0.31 * length).epsilon(0.05));
  }
}

TEST_CASE("the default car's four wheels stand on the ground and are round") {
  for (const geometry::Vehicle& vehicle : kVehicles) {
    const CarModel model = default_car(vehicle);
    CHECK(bounding_box(model).min().z() == Approx(0).margin(1e-5 * vehicle.length_m));
    const Part& tyres = part(model, "tyre");
    Eigen::AlignedBox3f wheels[2][2];  // rear and front, right and left
    for (uint32_t i = 0; i < tyres.index_count; ++i) {
      const Eigen::Vector3f& p = model.vertices[model.indices[tyres.first_index + i]].position;
      wheels[p.x() > 0][p.y() > 0].extend(p);
    }
    for (const auto& axle : wheels)
      for (const Eigen::AlignedBox3f& wheel : axle) {
        CHECK(wheel.min().z() == Approx(0).margin(1e-5 * vehicle.length_m));
        CHECK(wheel.sizes().x() == Approx(wheel.sizes().z()).epsilon(0.01));
        CHECK(wheel.sizes().x() == Approx(0.14 * vehicle.length_m).epsilon(0.05));
      }
  }
}

TEST_CASE("the default car's parts are contiguous, opaque ones first, and of a size that draws fast") {
  const CarModel model = default_car({4.8, 1.9});
  CHECK(model.triangle_count() > 5000);
  CHECK(model.triangle_count() < 20000);
  uint32_t next = 0;
  bool opaque = true;
  for (const Part& p : model.parts) {
    CHECK(p.first_index == next);
    CHECK(p.index_count % 3 == 0);
    CHECK(p.index_count > 0);
    CHECK((opaque || !p.material.opaque()));
    opaque = p.material.opaque();
    next += p.index_count;
  }
  CHECK(next == model.indices.size());
  CHECK(std::ranges::all_of(model.indices, [&](uint32_t i) { return i < model.vertices.size(); }));
  for (const char* name : {"paint", "glass", "tyre", "rim", "light_front", "light_rear", "trim"})
    part(model, name);
  CHECK_FALSE(part(model, "glass").material.opaque());
}

TEST_CASE("the default car's normals are unit, and its left and right are mirror images") {
  const CarModel model = default_car({4.8, 1.9});
  double balance = 0;
  for (const Vertex& v : model.vertices) {
    REQUIRE(v.normal.norm() == Approx(1).epsilon(1e-4));
    balance += v.position.y();
  }
  CHECK(std::abs(balance) / static_cast<double>(model.vertices.size()) < 0.01);
}

TEST_CASE("from all around and above, what is seen of the default car faces the eye") {
  const geometry::Vehicle vehicle{4.8, 1.9};
  const CarModel model = default_car(vehicle);
  for (int direction = 0; direction < 9; ++direction) {
    const double angle = direction * 0.785398;
    const Eigen::Vector3d eye = direction == 8
                                    ? Eigen::Vector3d(0, 0, 9)
                                    : Eigen::Vector3d(7 * std::cos(angle), 7 * std::sin(angle), 2.5);
    const Viewpoint viewpoint = look_at(eye, {0, 0, 0.6}, 300, {300, 300});
    Rasteriser rasteriser;
    rasteriser.project(model, viewpoint, 0.05);
    rasteriser.sort(model, static_cast<uint32_t>(model.triangle_count()), {0, 0, 300, 300});
    std::vector<SampleBand> bands(rasteriser.band_count());
    for (int band = 0; band < rasteriser.band_count(); ++band) rasteriser.draw(model, band, bands[band]);
    constexpr int kRows = Rasteriser::kBandRows * kSamplesPerSide;
    size_t facing = 0, all = 0;
    for (int j = 0; j < 600; ++j)
      for (int i = 0; i < 600; ++i) {
        const uint32_t triangle = bands[j / kRows].sample(i, j % kRows).opaque;
        if (triangle == kNoTriangle) continue;
        const auto corner = [&](size_t k) {
          return model.vertices[model.indices[3 * triangle + k]].position;
        };
        const Eigen::Vector3f plane = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        facing += plane.dot(eye.cast<float>() - corner(0)) > 0;
        ++all;
      }
    CHECK(all > 20000);
    CHECK(static_cast<double>(facing) > 0.995 * static_cast<double>(all));  // a closed skin hides its insides
  }
}
