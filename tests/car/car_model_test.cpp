#include "algorithms/car/car_model.h"

#include "tests/car/small_models.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::car;
using namespace svchain::testing;

namespace {

const Material kPaint = {"paint", {0.5f, 0.5f, 0.5f}, 1, 0.5f, 0};
const Material kPane = {"glass", {0, 0, 0}, 0.5f, 1, 0};

void check_size(const CarModel& model, const Eigen::Vector3f& size) {
  const Eigen::AlignedBox3f box = bounding_box(model);
  CHECK((box.sizes() - size).norm() == Approx(0).margin(1e-4));
  CHECK(box.center().head<2>().norm() == Approx(0).margin(1e-4));
  CHECK(box.min().z() == Approx(0).margin(1e-4));
}

}  // namespace

TEST_CASE("a model is scaled to the vehicle's length as a whole, and placed on the ground below its middle") {
  const CarModel model = box_model({3, 5, 7}, {13, 9.2f, 10}, kPaint);
  check_size(fit_to(model, {5, 2}), {5, 2.1f, 1.5f});
}

TEST_CASE("a model whose width is off by more than 15 % gets the vehicle's width") {
  const CarModel model = box_model({0, 0, 0}, {10, 3, 3}, kPaint);
  check_size(fit_to(model, {5, 2}), {5, 2, 1.5f});
  check_size(fit_to(model, {5, 1.6}), {5, 1.5f, 1.5f});
}

TEST_CASE("normals stay unit and upright on their planes when only the width is scaled") {
  LooseTriangle slope;
  const Eigen::Vector3f points[] = {{0, 0, 0}, {2, 0, 0}, {0, 1, 1}};
  for (size_t i = 0; i < 3; ++i) slope.corners[i] = {points[i], {0, -std::sqrt(0.5f), std::sqrt(0.5f)}};
  const CarModel fitted = fit_to(assemble({kPaint}, std::span(&slope, 1)), {2, 4});
  for (const Vertex& vertex : fitted.vertices) {
    CHECK(vertex.normal.norm() == Approx(1));
    CHECK(vertex.normal.dot(Eigen::Vector3f(0, 4, 1)) == Approx(0).margin(1e-5));
  }
}

TEST_CASE("opaque parts come first, whatever the order of the materials") {
  const CarModel model =
      joined(box_model({0, 0, 0}, {1, 1, 1}, kPane), box_model({2, 0, 0}, {3, 1, 1}, kPaint));
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].material == kPaint);
  CHECK(model.parts[1].material == kPane);
  CHECK(model.parts[1].first_index == model.parts[0].index_count);
  CHECK(bounding_box(model, model.parts[1]).max().x() == 1);
}

TEST_CASE("edges turned by more than the crease angle stay sharp, others become smooth") {
  const auto fold = [](float rise) {
    const Eigen::Vector3f a(0, 0, 0), b(0, 1, 0), left(-1, 0, 0), right(1, 0, rise), none(0, 0, 0);
    return std::vector<LooseTriangle>{{{Vertex{a, none}, Vertex{b, none}, Vertex{left, none}}, 0},
                                      {{Vertex{a, none}, Vertex{right, none}, Vertex{b, none}}, 0}};
  };
  std::vector<LooseTriangle> gentle = fold(0.3f), steep = fold(3);
  smooth_normals(gentle, 40);
  smooth_normals(steep, 40);
  CHECK((gentle[0].corners[0].normal - gentle[1].corners[0].normal).norm() == Approx(0).margin(1e-6));
  CHECK(steep[0].corners[0].normal.z() == Approx(1));
  CHECK(steep[1].corners[0].normal.x() < -0.9f);
}

TEST_CASE("triangles are turned to face where their normals point") {
  CarModel box = box_model({0, 0, 0}, {1, 1, 1}, kPaint);
  CHECK(box.triangle_count() == 12);
  CHECK(box.vertices.size() == 24);
  for (size_t i = 0; i < box.indices.size(); i += 3) {
    const auto corner = [&](size_t k) { return box.vertices[box.indices[i + k]]; };
    const Eigen::Vector3f plane =
        (corner(1).position - corner(0).position).cross(corner(2).position - corner(0).position);
    CHECK(plane.dot(corner(0).normal) > 0);
  }
}
