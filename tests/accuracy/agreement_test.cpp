#include "usecases/svchain_accuracy/agreement.h"

#include "algorithms/calibration/scene_charts.h"
#include "tests/catch.h"
#include "usecases/svchain_accuracy/trial.h"

using namespace svchain;
using namespace svchain::accuracy;
using calibration::CornerState;
using calibration::HoldOut;

namespace {

/// A calibration that is the truth, odd corners held out of it, all exactly where cameras see them.
calibration::Calibration true_calibration() {
  const scene::Scene scene = trial_scene("car", "kannala_brandt", 7);
  calibration::Calibration made;
  made.rig = scene.rig;
  made.charts = calibration::charts_of(scene);
  for (size_t c = 0; c < 4; ++c) {
    for (size_t k = 0; k < made.charts.size(); ++k) {
      const auto places = calibration::corners(made.charts[k]);
      for (size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector2d ground = made.charts[k].vehicle_from_chart.value() * places[i].place_m;
        const auto pixel = made.rig.cameras[c].see({ground.x(), ground.y(), 0});
        if (!pixel) continue;
        const auto state = i % 2 == 1 ? CornerState::kHeldOut : CornerState::kFitted;
        made.corners.push_back({c, k, static_cast<int>(i), state, *pixel, *pixel});
      }
    }
  }
  return made;
}

}  // namespace

TEST_CASE("the true rig agrees with corners that were held out, and only they count") {
  const auto made = true_calibration();
  Agreement agreement;
  add_held_out(made, made.rig, HoldOut::kOdd, agreement);
  for (size_t c = 0; c < 4; ++c) {
    CHECK(agreement.ground_cm[c].count() == 12);
    CHECK(agreement.ground_cm[c].rms() == Approx(0).margin(1e-6));
    CHECK(agreement.pair_cm[c].count() == 6);
    CHECK(agreement.pair_cm[c].rms() == Approx(0).margin(1e-6));
  }
}

TEST_CASE("a camera that is shifted disagrees with the charts and both its neighbours by the shift") {
  const auto made = true_calibration();
  geometry::Rig off = made.rig;
  off.cameras[0].vehicle_from_camera.translation.y() += 0.02;
  Agreement agreement;
  add_held_out(made, off, HoldOut::kOdd, agreement);
  CHECK(agreement.ground_cm[0].rms() == Approx(2));
  CHECK(agreement.across_cm[0].rms() < 2);
  CHECK(agreement.pair_cm[0].median() == Approx(2));
  CHECK(agreement.pair_cm[3].rms() == Approx(2));
  CHECK(agreement.pair_cm[1].rms() == Approx(0).margin(1e-6));
}

TEST_CASE("held-out corners that are outliers are counted by themselves") {
  auto made = true_calibration();
  made.corners[1].state = CornerState::kRejected;
  Agreement agreement;
  add_held_out(made, made.rig, HoldOut::kOdd, agreement);
  CHECK(agreement.rejected == 1);
  CHECK(agreement.ground_cm[0].count() == 11);
}
