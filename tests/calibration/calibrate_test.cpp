#include <algorithm>

#include "algorithms/calibration/content_start.h"
#include "algorithms/calibration/levelling.h"
#include "algorithms/calibration/scene_charts.h"
#include "algorithms/scene/nominal_rig.h"
#include "tests/calibration/calibration_scene.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::calibration;

namespace {

/// RMS of how far the ground of two rigs is apart within 3 m of the vehicle, mm, worst camera, after the best
/// common motion of all cameras.
double ground_apart_mm(const geometry::Rig& rig, const geometry::Rig& truth) {
  std::vector<Eigen::Vector2d> from, to;
  std::vector<size_t> camera;
  for (size_t c = 0; c < rig.cameras.size(); ++c) {
    const auto& ours = rig.cameras[c];
    const auto& theirs = truth.cameras[c];
    for (int y = 8; y < ours.image_size_px.y(); y += 24) {
      for (int x = 8; x < ours.image_size_px.x(); x += 24) {
        const auto a = ground_of(*ours.lens, ours.vehicle_from_camera, {x, y});
        const auto b = ground_of(*theirs.lens, theirs.vehicle_from_camera, {x, y});
        const Eigen::Vector2d reach(truth.vehicle.length_m / 2 + 3, truth.vehicle.width_m / 2 + 3);
        if (!a || !b || (b->cwiseAbs().array() > reach.array()).any()) continue;
        from.push_back(*a);
        to.push_back(*b);
        camera.push_back(c);
      }
    }
  }
  const geometry::Pose2 common = pose_between(from, to);
  std::vector<double> sum(4, 0), count(4, 0);
  for (size_t i = 0; i < from.size(); ++i) {
    sum[camera[i]] += (common * from[i] - to[i]).squaredNorm();
    ++count[camera[i]];
  }
  double worst = 0;
  for (size_t c = 0; c < 4; ++c) worst = std::max(worst, 1000 * std::sqrt(sum[c] / count[c]));
  return worst;
}

}  // namespace

// One case, so that the pictures are rendered once.
TEST_CASE("four cameras calibrate from a parking lot with four charts") {
  SECTION("posed charts calibrate four cameras to a hundredth of a degree and a millimetre") {
    const Calibration calibration = calibrate(testing::parking_input());
    CHECK(calibration.accepted());
    const auto error = testing::worst_error(calibration.rig, testing::parking_truth());
    CHECK(error.rotation_deg < 0.01);
    CHECK(error.place_mm < 1);
    CHECK(ground_apart_mm(calibration.rig, testing::parking_truth()) < 1);
    for (const auto& camera : calibration.cameras) {
      CHECK(camera.points == 24);
      CHECK(camera.lens_change_px == 0);
    }
  }

  SECTION("charts that nobody measured calibrate as well, but for a common motion") {
    CalibrationInput input = testing::parking_input();
    for (auto& chart : input.charts) chart.vehicle_from_chart.reset();
    const Calibration calibration = calibrate(input);
    CHECK(calibration.accepted());
    CHECK(ground_apart_mm(calibration.rig, testing::parking_truth()) < 2);
    const auto truth = testing::parking_input().charts;
    for (size_t k = 0; k < truth.size(); ++k) {
      REQUIRE(calibration.charts[k].vehicle_from_chart);
      const auto& found = *calibration.charts[k].vehicle_from_chart;
      CAPTURE(truth[k].name);
      CHECK(std::hypot(found.x_m - truth[k].vehicle_from_chart->x_m,
                       found.y_m - truth[k].vehicle_from_chart->y_m) < 0.05);
    }
  }

  SECTION("a calibration is near the truth by its own sigmas") {
    const Calibration calibration = calibrate(testing::parking_input());
    const auto& truth = testing::parking_truth();
    for (size_t c = 0; c < truth.cameras.size(); ++c) {
      const auto& ours = calibration.rig.cameras[c].vehicle_from_camera;
      const auto& theirs = truth.cameras[c].vehicle_from_camera;
      const Eigen::AngleAxisd turn(ours.rotation * theirs.rotation.conjugate());
      const Eigen::Vector3d turn_deg = turn.axis() * turn.angle() * 180 / M_PI;
      const Eigen::Vector3d shift_mm = 1000 * (ours.translation - theirs.translation);
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::abs(turn_deg[axis]) < 5 * calibration.cameras[c].sigma_rotation_deg[axis]);
        CHECK(std::abs(shift_mm[axis]) < 5 * calibration.cameras[c].sigma_translation_mm[axis]);
      }
    }
  }

  SECTION("what is held out is not fitted, and the results are about it") {
    CalibrationInput input = testing::parking_input();
    input.hold_out = HoldOut::kOdd;
    const Calibration calibration = calibrate(input);
    CHECK(calibration.accepted());
    for (const auto& camera : calibration.cameras) CHECK(camera.points == 12);
    for (const auto& corner : calibration.corners) {
      if (corner.state == CornerState::kHeldOut) CHECK(corner.corner % 2 == 1);
      if (corner.state == CornerState::kFitted) CHECK(corner.corner % 2 == 0);
    }
    const auto error = testing::worst_error(calibration.rig, testing::parking_truth());
    CHECK(error.rotation_deg < 0.02);
  }

  SECTION("the pictures alone tell how the cameras stand, where nobody does") {
    CalibrationInput input = testing::parking_input();
    for (auto& chart : input.charts) chart.vehicle_from_chart.reset();
    for (auto& camera : input.nominal.cameras) camera.vehicle_from_camera = {};
    start_from_content(input);
    const Calibration calibration = calibrate(input);
    for (const auto& camera : calibration.cameras) {
      CAPTURE(camera.reasons);
      CHECK(camera.reasons.empty());
    }
    CHECK(calibration.accepted());
    CHECK(ground_apart_mm(calibration.rig, testing::parking_truth()) < 2);
    const auto error = testing::worst_error(calibration.rig, testing::parking_truth());
    CHECK(error.rotation_deg < 5);
    CHECK(error.place_mm < 300);
  }

  SECTION("where charts have a place, it tells where the cameras are that nobody knows") {
    CalibrationInput input = testing::parking_input();
    for (auto& camera : input.nominal.cameras) camera.vehicle_from_camera = {};
    start_from_content(input);
    const Calibration calibration = calibrate(input);
    CHECK(calibration.accepted());
    const auto error = testing::worst_error(calibration.rig, testing::parking_truth());
    CHECK(error.rotation_deg < 0.01);
    CHECK(error.place_mm < 1);
  }

  SECTION("the same pictures give the same rig") {
    CHECK(geometry::rig_text(calibrate(testing::parking_input()).rig) ==
          geometry::rig_text(calibrate(testing::parking_input()).rig));
  }
}

TEST_CASE("a toy calibrates to a tenth of a millimetre") {
  const scene::Scene toy = testing::shipped_scene("toy");
  CalibrationInput input;
  input.nominal = scene::nominal_rig(toy);
  input.charts = charts_of(toy);
  input.pictures = testing::pictures_of(toy);
  const Calibration calibration = calibrate(input);
  CHECK(calibration.accepted());
  const auto error = testing::worst_error(calibration.rig, toy.rig);
  CHECK(error.rotation_deg < 0.015);
  CHECK(error.place_mm < 0.1);
}
