#include "usecases/svchain_accuracy/pose_error.h"

#include <algorithm>

#include "algorithms/geometry/angles.h"
#include "tests/catch.h"
#include "usecases/svchain_accuracy/trial.h"

using namespace svchain;
using namespace svchain::accuracy;
using Eigen::Vector3d;

namespace {

geometry::Rig car() {
  return trial_scene("car", "kannala_brandt", 7).rig;
}

/// All cameras turned about the vertical and shifted together.
geometry::Rig moved(geometry::Rig rig, double yaw_deg, const Vector3d& shift_m) {
  const geometry::Rigid3 motion{
      Eigen::Quaterniond(Eigen::AngleAxisd(geometry::radians(yaw_deg), Vector3d::UnitZ())), shift_m};
  for (auto& camera : rig.cameras) camera.vehicle_from_camera = motion * camera.vehicle_from_camera;
  return rig;
}

}  // namespace

TEST_CASE("the true rig has no error") {
  const PoseError worst = worst_of(pose_errors(car(), car()));
  CHECK(worst.rotation_deg == Approx(0).margin(1e-9));
  CHECK(worst.translation_mm == Approx(0).margin(1e-9));
  CHECK(worst.ground_mm == Approx(0).margin(1e-6));
}

TEST_CASE("a camera that is turned and shifted is off by just that, in its stated sigmas too") {
  geometry::Rig off = car();
  auto& pose = off.cameras[1].vehicle_from_camera;
  pose = turned_and_shifted(pose, Vector3d(0, 0, geometry::radians(0.2)), Vector3d(0.01, 0, 0));
  std::vector<calibration::CameraAccuracy> stated(4);
  for (auto& camera : stated) {
    camera.sigma_rotation_deg.setConstant(0.1);
    camera.sigma_translation_mm.setConstant(2);
  }
  const auto errors = pose_errors(car(), off, stated);
  CHECK(errors[0].sigmas == Approx(0).margin(1e-6));
  CHECK(errors[1].rotation_deg == Approx(0.2));
  CHECK(errors[1].translation_mm == Approx(10));
  CHECK(errors[1].sigmas == Approx(5));
}

TEST_CASE("a camera shifted along the ground is off on it by as much") {
  geometry::Rig off = car();
  for (auto& camera : off.cameras) camera.vehicle_from_camera.translation += Vector3d(0.003, 0.004, 0);
  for (const auto& error : pose_errors(car(), off)) CHECK(error.ground_mm == Approx(5));
}

TEST_CASE("a motion common to all cameras is no error in the best place") {
  const geometry::Rig off = moved(car(), 1.5, {0.1, -0.05, 0});
  CHECK(worst_of(pose_errors(car(), off)).ground_mm > 50);
  const PoseError worst = worst_of(pose_errors(car(), in_best_place(car(), off)));
  CHECK(worst.rotation_deg == Approx(0).margin(1e-6));
  CHECK(worst.translation_mm == Approx(0).margin(1e-6));
  CHECK(worst.ground_mm == Approx(0).margin(1e-6));
}

TEST_CASE("the best place does not take away what cameras are off against each other") {
  geometry::Rig off = car();
  off.cameras[2].vehicle_from_camera.translation.x() += 0.02;
  CHECK(worst_of(pose_errors(car(), in_best_place(car(), off))).ground_mm > 10);
}
