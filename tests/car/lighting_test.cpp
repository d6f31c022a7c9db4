#include "algorithms/car/lighting.h"

#include <random>

#include "algorithms/car/contact_shadow.h"
#include "algorithms/car/row_lighting.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::car;

TEST_CASE("the sky's light changes gradually from the ground's to the zenith's") {
  const Light light = bright_day();
  CHECK((sky(light, {0, 0, 1}) - light.zenith).norm() == Approx(0).margin(1e-5));
  CHECK((sky(light, {0, 0, -1}) - light.ground).norm() == Approx(0).margin(1e-5));
  Eigen::Vector3f before = sky(light, {0, 0, -1});
  for (float z = -0.99f; z <= 1; z += 0.01f) {
    const Eigen::Vector3f now = sky(light, {std::sqrt(1 - z * z), 0, z});
    CHECK((now - before).norm() < 0.2f);
    before = now;
  }
}

TEST_CASE(
    "a surface that faces the sun is brighter than one that faces away, and one near the ground darker") {
  const Light light = bright_day();
  const Material matt = {"paint", {0.5f, 0.5f, 0.5f}, 1, 0, 0};
  const Eigen::Vector3f up(0, 0, 1), down(0, 0, -1);
  CHECK(lit(light, matt, up, up, 1).colour.sum() > 2 * lit(light, matt, down, down, 1).colour.sum());
  CHECK(lit(light, matt, up, up, 0).colour.sum() < lit(light, matt, up, up, 1).colour.sum());
}

TEST_CASE("glass lets through what is behind it, less so at grazing angles, where it mirrors") {
  const Light light = bright_day();
  const Material glass = {"glass", {0, 0, 0}, 0.5f, 1, 0};
  const Eigen::Vector3f up(0, 0, 1), grazing = Eigen::Vector3f(1, 0, 0.05f).normalized();
  const Lit straight = lit(light, glass, up, up, 1), flat = lit(light, glass, up, grazing, 1);
  CHECK(straight.alpha == Approx(0.5 + 0.5 * 0.04));
  CHECK(flat.alpha > 0.85f);
  CHECK(flat.colour.sum() > 5 * straight.colour.sum());
}

TEST_CASE("what a display shows rises from black to white") {
  CHECK(display(0) == 0);
  CHECK(display(1.4143f) == Approx(1).epsilon(1e-3));
  CHECK(display(5) == 1);
  for (float c = 0; c < 1.4f; c += 0.01f) CHECK(display(c + 0.01f) > display(c));
}

TEST_CASE("the contact shadow hides the ground under the car, fades around it and ends at its reach") {
  const ContactShadow shadow({4.8, 1.9});
  CHECK(shadow.shadow_at({0, 0}) == 1);
  CHECK(shadow.shadow_at({2.4f, 0.95f}) > 0.75f);
  for (const float side : {-1.0f, 1.0f}) {
    CHECK(shadow.shadow_at({side * 2.39f, 0}) == 1);
    CHECK(shadow.shadow_at({side * 2.61f, 0}) == Approx(0.5).margin(0.15));
    CHECK(shadow.shadow_at({0, side * 0.94f}) == 1);
    CHECK(shadow.shadow_at({0, side * 1.16f}) == Approx(0.5).margin(0.15));
    CHECK(shadow.shadow_at({side * shadow.reach().x(), 0}) == Approx(0).margin(1e-6));
    CHECK(shadow.shadow_at({0, side * shadow.reach().y()}) == Approx(0).margin(1e-6));
  }
  float before = 1;
  for (float y = 0; y < 1.5f; y += 0.01f) {
    CHECK(shadow.shadow_at({0.5f, y}) <= before);
    before = shadow.shadow_at({0.5f, y});
  }
}

TEST_CASE("samples lit many at once have the light that the definition gives each of them") {
  const std::vector<Material> materials = {{"paint", {0.03f, 0.1f, 0.24f}, 1, 0.92f, 0.45f},
                                           {"matt", {0.5f, 0.4f, 0.3f}, 1, 0, 0},
                                           {"glass", {0.01f, 0.02f, 0.03f}, 0.6f, 1, 0}};
  const std::vector<Substance> substances(materials.begin(), materials.end());
  std::mt19937 random(7);
  std::uniform_real_distribution<float> within(-1, 1);
  const auto vector = [&] { return Eigen::Vector3f(within(random), within(random), within(random)); };
  const Eigen::Vector3f eye(4, 3, 2);
  constexpr size_t kCount = 3 * kMostLanes;
  std::vector<Facet> facets;
  std::vector<int32_t> order;
  std::vector<float> columns(kCount), rows(kCount), rgba(4 * kCount);
  std::vector<Lit> expected;
  const Rays rays = {eye, Eigen::Vector3f(-4, -3, -1.2f), {0.006f, -0.008f, 0}, {0, 0.001f, -0.01f}};
  for (size_t k = 0; k < kCount; ++k) {
    columns[k] = 10 * within(random);
    rows[k] = 10 * within(random);
    const Eigen::Vector3f ray = rays.first + columns[k] * rays.right + rows[k] * rays.down;
    // A triangle around the point the ray meets.
    const Eigen::Vector3f point = eye + ray, u = vector().normalized(), v = vector();
    const Eigen::Vector3f normal = (2 * (eye - point).normalized() + vector()).normalized();
    const Eigen::Vector3f plane_u = normal.cross(u), plane_v = normal.cross(plane_u);
    const Vertex a = {point + 0.2f * plane_u, (normal + 0.1f * v).normalized()},
                 b = {point - 0.1f * plane_u + 0.2f * plane_v, a.normal},
                 c = {point - 0.1f * plane_u - 0.2f * plane_v, a.normal};
    const size_t part = k % materials.size();
    facets.push_back(facet_of({&a, &b, &c}, eye, static_cast<uint32_t>(part)));
    order.push_back(static_cast<int32_t>(k));
    expected.push_back(lit(bright_day(), materials[part], a.normal, -ray.normalized(), point.z() / 1.5f));
  }
  const Scenery scenery = {bright_day(), rays, 1.5f, facets.data(), substances.data()};
  light_samples(scenery, order.data(), columns.data(), rows.data(), kCount, rgba.data());
  for (size_t k = 0; k < kCount; ++k) {
    for (int c = 0; c < 3; ++c) REQUIRE(rgba[4 * k + c] == Approx(expected[k].colour[c]).margin(2e-3));
    REQUIRE(rgba[4 * k + 3] == Approx(expected[k].alpha).margin(1e-3));
  }
}
