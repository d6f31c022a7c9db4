#include "usecases/svchain_accuracy/trial.h"

#include "algorithms/calibration/scene_charts.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::accuracy;

namespace {

/// How many corners of the charts a camera sees.
int corners_seen(const scene::Scene& scene, size_t camera) {
  int seen = 0;
  for (const auto& chart : calibration::charts_of(scene)) {
    for (const auto& corner : calibration::corners(chart)) {
      const Eigen::Vector2d ground = chart.vehicle_from_chart.value() * corner.place_m;
      if (scene.rig.cameras[camera].see({ground.x(), ground.y(), 0})) ++seen;
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("every camera of a trial sees two charts, a pinhole most of them") {
  for (const std::string vehicle : {"car", "toy"}) {
    for (const std::string model : {"kannala_brandt", "pinhole"}) {
      const scene::Scene scene = trial_scene(vehicle, model, 3);
      INFO(vehicle << " " << model);
      for (size_t camera = 0; camera < 4; ++camera)
        CHECK(corners_seen(scene, camera) >= (model == "pinhole" ? 16 : 24));
    }
  }
}

TEST_CASE("the same seed draws the same trial, another seed another") {
  const auto place = [](uint64_t seed) {
    return trial_scene("car", "kannala_brandt", seed).rig.cameras[2].vehicle_from_camera.translation;
  };
  CHECK(place(5) == place(5));
  CHECK(place(5) != place(6));
}

TEST_CASE("charts without places keep everything else") {
  const auto posed = calibration::charts_of(trial_scene("toy", "kannala_brandt", 1));
  const auto free = unposed(posed);
  REQUIRE(free.size() == posed.size());
  for (size_t i = 0; i < free.size(); ++i) {
    CHECK_FALSE(free[i].vehicle_from_chart);
    CHECK(free[i].squares == posed[i].squares);
    CHECK(free[i].side_m == posed[i].side_m);
  }
}
