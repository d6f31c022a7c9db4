#include "usecases/svchain_accuracy/lens_like.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::geometry;

namespace {

KannalaBrandt car_lens() {
  return {{330, 330}, {641.2, 358.1}, {0.052, -0.0092, 0.0021, -0.0004}};
}

/// The farthest that pixels are apart, up to `widest_deg` from the axis.
double apart_px(const Lens& one, const Lens& other, int widest_deg) {
  double apart = 0;
  for (int degree = 0; degree <= widest_deg; ++degree) {
    const double t = radians(degree);
    const Eigen::Vector3d ray(std::sin(t) * 0.6, std::sin(t) * 0.8, std::cos(t));
    apart = std::max(apart, (one.project(ray).value() - other.project(ray).value()).norm());
  }
  return apart;
}

}  // namespace

TEST_CASE("lenses of every model but the pinhole are like the car's to two pixels") {
  for (const auto& model : accuracy::kLensModels) {
    if (model == "pinhole") continue;
    const auto lens = accuracy::lens_like(model, car_lens());
    INFO(model);
    CHECK(lens->model() == model);
    CHECK(apart_px(*lens, car_lens(), 90) < 2);
  }
}

TEST_CASE("a pinhole in the car lens's place shows 144 degrees") {
  const auto lens = accuracy::lens_like("pinhole", car_lens());
  CHECK(lens->model() == "pinhole");
  const double edge = radians(72);
  CHECK(lens->project({std::sin(edge), 0, std::cos(edge)}).value().x() < 1280);
  CHECK(lens->max_angle_rad() > edge);
}

TEST_CASE("a lens model that is none is refused") {
  CHECK_THROWS_AS(accuracy::lens_like("fisheye", car_lens()), std::invalid_argument);
}
