#include "algorithms/bowl/viewpoint_presets.h"
#include "tests/catch.h"
#include "tests/gl/parking.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

const synthesis::ToneMapping kTones = smooth_tone_mapping(false);

cv::Mat drawn_from(gl::BowlRenderer& renderer, const bowl::Viewpoint& viewpoint, float opacity) {
  return drawn(renderer, parking().bgr, kTones, viewpoint, opacity);
}

gl::CarDrawnBy either() {
  return GENERATE(gl::CarDrawnBy::kGl, gl::CarDrawnBy::kCpu);
}

}  // namespace

TEST_CASE("the renderer's car, lit and with its shadow, is the CPU's within two levels from every preset") {
  if (!has_gl()) return;
  const gl::CarDrawnBy by = either();
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  renderer->set_car(parking().car, parking().rig.vehicle, by);
  for (const float opacity : {1.0f, 0.5f})
    for (const std::string& name : bowl::preset_names()) {
      const bowl::Viewpoint viewpoint = parking().preset(name);
      cv::Rect car;
      const cv::Mat cpu = expected(parking().bgr, kTones, viewpoint, opacity, &car);
      const cv::Mat moved = drawn_from(*renderer, viewpoint, opacity);
      const cv::Mat still = drawn_from(*renderer, viewpoint, opacity);
      CAPTURE(name, opacity, by);
      CHECK(mean_difference(moved(car), cpu(car)) < 2);
      CHECK(cv::norm(moved, still, cv::NORM_INF) == 0);
      const cv::Mat without = expected(parking().bgr, kTones, viewpoint);
      CHECK(mean_difference(without(car), cpu(car)) > 10);
    }
}

TEST_CASE(
    "the renderer's car is drawn from within, half beyond the picture, and not where it is out of sight") {
  if (!has_gl()) return;
  const gl::CarDrawnBy by = either();
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  renderer->set_car(parking().car, parking().rig.vehicle, by);
  const std::vector<bowl::Viewpoint> viewpoints = {{{-0.2, 0.3, 1.1}, {3, 0.4, 0.9}, {0, 0, 1}, 70},
                                                   {{6, 0, 2}, {3, -5, 0}, {0, 0, 1}, 60},
                                                   {{6, 0, 2}, {12, 0, 1.5}, {0, 0, 1}, 60}};
  for (const bowl::Viewpoint& viewpoint : viewpoints) {
    const cv::Mat cpu = expected(parking().bgr, kTones, viewpoint, 1);
    CAPTURE(viewpoint.eye_m.transpose());
    CHECK(mean_difference(drawn_from(*renderer, viewpoint, 1), cpu) < 2.5);
  }
  const bowl::Viewpoint& away = viewpoints.back();
  CHECK(cv::norm(drawn_from(*renderer, away, 1), drawn_from(*renderer, away, 0), cv::NORM_INF) == 0);
}

TEST_CASE(
    "opacity 0 shows the renderer's picture without a car, and a model without triangles takes it away") {
  if (!has_gl()) return;
  const gl::CarDrawnBy by = either();
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const bowl::Viewpoint chase = parking().preset("chase");
  const cv::Mat before = drawn_from(*renderer, chase, 1);
  renderer->set_car(parking().car, parking().rig.vehicle, by);
  CHECK(cv::norm(drawn_from(*renderer, chase, 0), before, cv::NORM_INF) == 0);
  CHECK(mean_difference(drawn_from(*renderer, chase, 1), before) > 2);
  renderer->set_car({}, parking().rig.vehicle, by);
  CHECK(cv::norm(drawn_from(*renderer, chase, 1), before, cv::NORM_INF) == 0);
}
