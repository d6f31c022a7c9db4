#include "usecases/svchain_accuracy/plain_calibration.h"

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/scene/nominal_rig.h"
#include "tests/catch.h"
#include "usecases/svchain_accuracy/pose_error.h"
#include "usecases/svchain_accuracy/trial.h"

using namespace svchain;
using namespace svchain::accuracy;

namespace {

const scene::Scene& car() {
  static const scene::Scene scene = trial_scene("car", "kannala_brandt", 7);
  return scene;
}

/// The corners of the charts exactly where the cameras see them.
std::vector<std::vector<PlainCorner>> exact_corners() {
  std::vector<std::vector<PlainCorner>> all;
  for (const auto& camera : car().rig.cameras) {
    all.emplace_back();
    for (const auto& chart : calibration::charts_of(car())) {
      for (const auto& corner : calibration::corners(chart)) {
        const Eigen::Vector2d ground = chart.vehicle_from_chart.value() * corner.place_m;
        if (const auto pixel = camera.see({ground.x(), ground.y(), 0}))
          all.back().push_back({ground, *pixel});
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("poses refined from exact corners are the true ones") {
  const auto worst =
      worst_of(pose_errors(car().rig, poses_refined(scene::nominal_rig(car()), exact_corners())));
  CHECK(worst.rotation_deg < 1e-5);
  CHECK(worst.translation_mm < 1e-3);
}

TEST_CASE("a homography through exact corners maps the ground exactly, as far as an ideal pinhole reaches") {
  const auto corners = exact_corners();
  for (size_t c = 0; c < corners.size(); ++c) {
    const PlainHomography homography(car().rig.cameras[c].lens, corners[c]);
    for (const auto& corner : corners[c]) {
      const auto ground = homography.ground_of(corner.pixel);
      if (ground) CHECK((*ground - corner.ground_m).norm() < 1e-4);
    }
    CHECK(homography.ground_of(car().rig.cameras[c].image_size_px.cast<double>() / 2));
  }
  CHECK_FALSE(PlainHomography(car().rig.cameras[0].lens, corners[0]).ground_of({5, 360}));
}

TEST_CASE("plain corners of a chart painted by hand are found to a tenth of a pixel") {
  // Four black and white quarters around (640.5, 360.5), where the first and the second half meet.
  cv::Mat picture(720, 1280, CV_8UC3, cv::Scalar::all(0));
  picture(cv::Rect(0, 0, 641, 361)).setTo(cv::Scalar::all(255));
  picture(cv::Rect(641, 361, 639, 359)).setTo(cv::Scalar::all(255));
  geometry::Rig rig = car().rig;
  rig.cameras.resize(1);
  const auto ray = rig.cameras[0].lens->unproject({640.5, 360.5}).value();
  const auto& pose = rig.cameras[0].vehicle_from_camera;
  const Eigen::Vector3d sight = pose.rotation * ray;
  const Eigen::Vector3d ground = pose.translation - pose.translation.z() / sight.z() * sight;
  calibration::Chart chart;
  chart.squares = {2, 2};
  chart.side_m = 0.25;
  chart.vehicle_from_chart = geometry::Pose2{ground.x(), ground.y(), 0};
  const auto found = plain_corners(rig, {chart}, {picture});
  REQUIRE(found.front().size() == 1);
  CHECK((found.front().front().pixel - Eigen::Vector2d(640.5, 360.5)).norm() < 0.1);
}
