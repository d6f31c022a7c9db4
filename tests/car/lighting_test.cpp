#include "algorithms/car/lighting.h"

#include "algorithms/car/contact_shadow.h"
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
