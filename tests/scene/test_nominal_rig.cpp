#include "algorithms/geometry/angles.h"
#include "algorithms/scene/nominal_rig.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::scene;

namespace {

/// The largest component, along or about an axis of the vehicle, of how far two rigs' cameras are apart.
struct Apart {
  double position_m = 0, rotation_deg = 0;
};

Apart apart(const geometry::Rig& a, const geometry::Rig& b) {
  Apart most;
  for (size_t i = 0; i < 4; ++i) {
    const auto& pa = a.cameras[i].vehicle_from_camera;
    const auto& pb = b.cameras[i].vehicle_from_camera;
    const Eigen::AngleAxisd turn(pa.rotation * pb.rotation.conjugate());
    const Eigen::Vector3d vector = turn.angle() * turn.axis();
    const Eigen::Vector3d shift = pa.translation - pb.translation;
    most.position_m = std::max(most.position_m, shift.lpNorm<Eigen::Infinity>());
    most.rotation_deg = std::max(most.rotation_deg, geometry::degrees(vector.lpNorm<Eigen::Infinity>()));
  }
  return most;
}

}  // namespace

TEST_CASE("the nominal rig of a car is off by something, but by no more than 5 cm and 3 degrees an axis") {
  Scene scene = testing::small_scene();
  for (scene.seed = 1; scene.seed <= 50; ++scene.seed) {
    const Apart a = apart(nominal_rig(scene), scene.rig);
    CHECK(a.position_m > 0.01);
    CHECK(a.position_m <= 0.05);
    CHECK(a.rotation_deg > 0.6);
    CHECK(a.rotation_deg <= 3 + 1e-9);
  }
}

TEST_CASE(
    "on a toy a tenth as long the nominal positions are ten times as good, on a lorry they are no worse") {
  Scene scene = testing::small_scene();
  scene.rig.vehicle.length_m = 0.48;
  CHECK(nominal_position_m(scene) == Approx(0.005));
  CHECK(apart(nominal_rig(scene), scene.rig).position_m <= 0.005);
  scene.rig.vehicle.length_m = 12;
  CHECK(nominal_position_m(scene) == Approx(0.05));
}

TEST_CASE("a scene may say itself how good its nominal rig is, perfect too") {
  Scene scene = testing::small_scene();
  scene.nominal = {0.2, 0};
  const Apart a = apart(nominal_rig(scene), scene.rig);
  CHECK(a.position_m > 0.06);
  CHECK(a.position_m <= 0.2);
  CHECK(a.rotation_deg < 1e-9);
  scene.nominal = {0.0, 0};
  CHECK(geometry::rig_text(nominal_rig(scene)) == geometry::rig_text(scene.rig));
}

TEST_CASE("the same seed gives the same nominal rig, another seed another one") {
  Scene scene = testing::small_scene();
  const std::string text = geometry::rig_text(nominal_rig(scene));
  CHECK(geometry::rig_text(nominal_rig(scene)) == text);
  scene.seed = 2;
  CHECK(geometry::rig_text(nominal_rig(scene)) != text);
}

TEST_CASE("the nominal rig of a calibrated one is not calibrated") {
  Scene scene = testing::small_scene();
  scene.rig.calibration = "{}";
  CHECK(nominal_rig(scene).calibration.empty());
}
