#include "algorithms/scene/asphalt.h"
#include "algorithms/scene/paint.h"
#include "algorithms/scene/shapes.h"
#include "algorithms/scene/world.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::scene;

namespace {

int blue(const Texture& texture, int column, int row) {
  return static_cast<int>(texture.row(row)[column] & 255);
}

double painted_area(const Texture& texture) {
  double sum = 0;
  for (const uint32_t t : texture.texels) sum += (t & 255) / 255.0;
  return sum;
}

}  // namespace

TEST_CASE("a painted patch covers each texel by its exact area") {
  Texture texture(10, 10);  // of 1 m, the origin in the middle
  paint(texture, 1, 5, {{{-2, -2}, {1.25, -2}, {1.25, 1}, {-2, 1}}, {255, 255, 255}, 1});
  CHECK(blue(texture, 3, 3) == 255);
  CHECK(blue(texture, 5, 5) == 255);
  CHECK(blue(texture, 6, 5) == Approx(64).margin(1));
  CHECK(blue(texture, 7, 5) == 0);
  CHECK(blue(texture, 5, 6) == 0);
  CHECK(blue(texture, 2, 4) == 0);
}

TEST_CASE("a patch covers the same area however it is turned and wherever it lies") {
  for (const double yaw : {0.0, 0.2, 0.7, 1.5, 3.0}) {
    Texture texture(64, 64);
    paint(texture, 1, 32, {rectangle({1.3, -2.7, yaw}, 21.5, 3.3), {255, 255, 255}, 1});
    CHECK(painted_area(texture) == Approx(21.5 * 3.3).epsilon(0.01));
  }
  Texture texture(64, 64);
  paint(texture, 1, 32, {disc({0.4, 0.1, 0}, 12), {255, 255, 255}, 1});
  CHECK(painted_area(texture) == Approx(3.14159 * 144).epsilon(0.01));
}

TEST_CASE("paint beyond the texture is left away") {
  Texture texture(16, 16);
  paint(texture, 1, 8, {rectangle({100, 0, 0}, 5, 5), {255, 255, 255}, 1});
  paint(texture, 1, 8, {rectangle({-8, -8, 0.5}, 4, 4), {255, 255, 255}, 1});
  CHECK(painted_area(texture) > 1);
  CHECK(painted_area(texture) < 16);
}

TEST_CASE("half opaque paint lets half of the ground through") {
  Texture texture(4, 4);
  paint(texture, 1, 2, {rectangle({}, 4, 4), {200, 100, 50}, 0.5});
  CHECK(blue(texture, 1, 1) == Approx(100).margin(1));
}

TEST_CASE("asphalt keeps its colour at every scale and its grain fades") {
  Ground ground;
  ground.colour = {90, 100, 110};
  ground.grain_contrast = 0.15;
  ground.blotch_contrast = 0;
  const Asphalt asphalt(ground, 0.005, 3);
  double last_deviation = 1e9;
  for (const int level : {0, 2, 4}) {
    const Texture texture = asphalt.lay(level, 512);
    double sum = 0, squares = 0;
    for (const uint32_t t : texture.texels) sum += t & 255, squares += (t & 255) * (t & 255);
    const double mean = sum / static_cast<double>(texture.texels.size());
    const double deviation = std::sqrt(squares / static_cast<double>(texture.texels.size()) - mean * mean);
    CHECK(mean == Approx(90).margin(1));
    CHECK(deviation < last_deviation);
    if (level == 0) CHECK(deviation == Approx(0.15 * 90).epsilon(0.1));
    last_deviation = deviation;
  }
}

TEST_CASE("the square of a checkerboard at -x, -y is black and half a square of white is around") {
  Scene scene = testing::small_scene();
  const Checkerboard board{"board", {5, 4}, 0.25, {1, 1, 0.3}};
  scene.charts.push_back(board);
  const World world(scene);
  const GroundLevel& level = world.ground().front();
  const auto seen = [&](double i, double j) {  // in squares from the -x, -y corner
    const Eigen::Vector2d place = board.world_from_chart * Eigen::Vector2d((i - 2.5) * 0.25, (j - 2) * 0.25);
    return blue(level.texture, static_cast<int>(std::lround(level.texel_at(place.x()))),
                static_cast<int>(std::lround(level.texel_at(place.y()))));
  };
  CHECK(seen(0.5, 0.5) < 50);
  CHECK(seen(1.5, 0.5) > 200);
  CHECK(seen(0.5, 1.5) > 200);
  CHECK(seen(1.5, 1.5) < 50);
  CHECK(seen(-0.3, 2) > 200);
  CHECK(seen(2, 4.3) > 200);
  CHECK(seen(-0.7, 2) == 100);
}

TEST_CASE("the level nearest to a footprint is taken, unless it does not reach as far") {
  const World world(testing::small_scene());
  REQUIRE(world.ground().size() >= 4);
  CHECK(world.level_for(0.001, 1) == 0u);
  CHECK(world.level_for(0.021, 1) == 1u);
  CHECK(world.level_for(0.001, 6) == 1u);
  CHECK(world.level_for(0.001, 12) == 2u);
  CHECK(world.level_for(100, 1) == world.ground().size() - 1);
  CHECK_FALSE(world.level_for(0.001, 1000));
}
