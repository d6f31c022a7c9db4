#include "algorithms/geometry/lens_parameters.h"

#include <Eigen/LU>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "algorithms/geometry/lens_json.h"
#include "tests/geometry/all_lenses.h"

using namespace svchain::geometry;
using namespace svchain::testing;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

size_t index_of(const Lens& lens, const std::string& name) {
  const auto names = lens_parameter_names(lens);
  const auto found = std::find(names.begin(), names.end(), name);
  REQUIRE(found != names.end());
  return static_cast<size_t>(found - names.begin());
}

/// Rays well inside the largest angle, all around. Not the axis: there a polynomial with even powers has a
/// kink.
void for_inner_rays(const Lens& lens, const std::function<void(const Vector3d&)>& check) {
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 5; ++j) check(ray(lens.max_angle_rad() * 0.08 * (i + 0.4), 0.3 + 2 * kPi * j / 5));
  }
}

/// Slope of f at 0 by Richardson's extrapolation from two central differences.
Vector2d slope(const std::function<Vector2d(double)>& f, double step) {
  const auto central = [&](double h) -> Vector2d { return (f(h) - f(-h)) / (2 * h); };
  return (4 * central(step / 2) - central(step)) / 3;
}

}  // namespace

TEST_CASE("a lens made of its own parameters projects as before, to the last bit") {
  for_all_lenses([](const Lens& lens) {
    const auto parameters = lens_parameters(lens);
    CHECK_FALSE(parameters.empty());
    CHECK(parameters.size() == lens_parameter_names(lens).size());
    const auto same = with_parameters(lens, parameters);
    REQUIRE(same);
    CHECK(same->model() == lens.model());
    CHECK(same->max_angle_rad() == lens.max_angle_rad());
    CHECK(lens_parameters(*same) == parameters);
    bool equal = true;
    for_all_rays(lens, [&](const Vector3d& r) { equal = equal && same->project(r) == lens.project(r); });
    CHECK(equal);
  });
}

TEST_CASE("a lens with another centre shifts every pixel by just that") {
  for_all_lenses([](const Lens& lens) {
    auto parameters = lens_parameters(lens);
    parameters[index_of(lens, "centre_px.x")] += 3;
    parameters[index_of(lens, "centre_px.y")] -= 2;
    const auto shifted = with_parameters(lens, parameters);
    REQUIRE(shifted);
    double worst_px = 0;
    for_all_rays(lens, [&](const Vector3d& r) {
      worst_px = std::max(worst_px, (*shifted->project(r) - *lens.project(r) - Vector2d(3, -2)).norm());
    });
    CHECK(worst_px < 1e-9);
  });
}

TEST_CASE("a lens with other parameters has these, and is written to rig files and read back with them") {
  for_all_lenses([](const Lens& lens) {
    auto parameters = lens_parameters(lens);
    for (double& parameter : parameters) parameter *= 1.01;
    const auto changed = with_parameters(lens, parameters);
    REQUIRE(changed);
    const auto document = svchain::json::Document::parse(lens_json(*changed).dump(), "lens");
    REQUIRE(document);
    svchain::Faults faults;
    const auto back = read_lens(svchain::json::Value(*document, faults));
    CHECK(faults.empty());
    REQUIRE(back);
    const auto read = lens_parameters(*back);
    for (size_t i = 0; i < read.size(); ++i) CHECK(read[i] == Approx(parameters[i]));
  });
}

TEST_CASE("every lens parameter moves pixels, in a way that the others cannot make up for") {
  for_all_lenses([](const Lens& lens) {
    const LensVariations variations(lens);
    const auto count = static_cast<Eigen::Index>(lens_parameters(lens).size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    for_inner_rays(lens, [&](const Vector3d& r) {
      const auto by = variations.by_parameters(r);
      REQUIRE(by);
      normal += by->transpose() * *by;
    });
    const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    REQUIRE(scale.allFinite());
    const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const auto rank = Eigen::FullPivLU<Eigen::MatrixXd>(scaled).setThreshold(1e-13).rank();
    CHECK(rank == count);
  });
}

TEST_CASE("how a pixel follows its ray agrees with finer differences, whatever the ray's length") {
  for_all_lenses([](const Lens& lens) {
    const bool smooth = lens.model() != "table";  // a table's slope is continuous but bends at its nodes
    const double close = smooth ? 1e-6 : 2e-2;
    for_inner_rays(lens, [&](const Vector3d& unit) {
      for (const double length : {1.0, 4.0}) {
        const Vector3d r = length * unit;
        const auto jacobian = project_with_jacobian(lens, r);
        REQUIRE(jacobian);
        CHECK(jacobian->pixel == *lens.project(r));
        for (int axis = 0; axis < 3; ++axis) {
          const auto by_axis = slope(
              [&](double h) -> Vector2d { return *lens.project(r + length * h * Vector3d::Unit(axis)); },
              1e-4);
          CHECK((jacobian->by_ray.col(axis) * length - by_axis).norm() < close * (1 + by_axis.norm()));
        }
        CHECK((jacobian->by_ray * r).norm() < close * (1 + jacobian->by_ray.norm() * length));
      }
    });
  });
}

TEST_CASE("how a pixel follows its ray is undone by how the ray follows the pixel") {
  for_all_lenses([](const Lens& lens) {
    if (lens.model() == "ocam") return;  // its pixels next to the centre have no ray of their own
    const double close = lens.model() == "table" ? 1e-2 : 1e-4;
    for_inner_rays(lens, [&](const Vector3d& r) {
      const auto jacobian = project_with_jacobian(lens, r);
      REQUIRE(jacobian);
      constexpr double kStepPx = 1e-2;
      Eigen::Matrix<double, 3, 2> ray_by_pixel;
      for (int axis = 0; axis < 2; ++axis) {
        const Vector2d step = kStepPx * Vector2d::Unit(axis);
        ray_by_pixel.col(axis) =
            (*lens.unproject(jacobian->pixel + step) - *lens.unproject(jacobian->pixel - step)) /
            (2 * kStepPx);
      }
      CHECK((jacobian->by_ray * ray_by_pixel - Eigen::Matrix2d::Identity()).norm() < close);
    });
  });
}

TEST_CASE("how a pixel follows the lens's parameters agrees with finer differences") {
  for_all_lenses([](const Lens& lens) {
    const auto parameters = lens_parameters(lens);
    const LensVariations variations(lens);
    for_inner_rays(lens, [&](const Vector3d& r) {
      const auto by = variations.by_parameters(r);
      REQUIRE(by);
      for (size_t i = 0; i < parameters.size(); ++i) {
        const auto expected = slope(
            [&](double h) -> Vector2d {
              auto changed = parameters;
              changed[i] += h;
              return *with_parameters(lens, changed)->project(r);
            },
            1e-4 * (1 + std::abs(parameters[i])));
        INFO(lens_parameter_names(lens)[i]);
        CHECK((by->col(static_cast<Eigen::Index>(i)) - expected).norm() < 1e-5 * (1 + expected.norm()));
      }
    });
  });
}

TEST_CASE("beyond the largest angle no pixel follows anything") {
  for_all_lenses([](const Lens& lens) {
    const Vector3d rim = ray(lens.max_angle_rad(), 1.0), beyond = ray(lens.max_angle_rad() + 1e-6, 1.0);
    CHECK(project_with_jacobian(lens, rim));
    CHECK_FALSE(project_with_jacobian(lens, beyond));
    CHECK_FALSE(LensVariations(lens).by_parameters(beyond));
  });
}

TEST_CASE("parameters of no lens make none") {
  const KannalaBrandt lens({300, 300}, {640, 360}, {0, 0, 0, 0});
  auto parameters = lens_parameters(lens);
  CHECK_FALSE(with_parameters(lens, {300, 300}));
  parameters[0] = -300;
  CHECK_FALSE(with_parameters(lens, parameters));
  parameters[0] = 300;
  parameters[4] = -1e5;  // r turns at once
  CHECK_FALSE(with_parameters(lens, parameters));
  parameters[4] = std::nan("");
  CHECK_FALSE(with_parameters(lens, parameters));
}
