#include "algorithms/scene/nominal_rig.h"

#include <algorithm>

#include "algorithms/geometry/angles.h"
#include "algorithms/scene/hash.h"

namespace svchain::scene {

namespace {

constexpr double kCarLengthM = 4.8;
constexpr double kCarPositionM = 0.05;

enum Part : uint64_t { kPosition = 0x706f73, kRotation = 0x726f74 };

/// Each component from -1 to 1.
Eigen::Vector3d error(const Scene& scene, size_t camera, Part part) {
  Eigen::Vector3d error;
  for (int axis = 0; axis < 3; ++axis) error[axis] = 2 * unit(hash(scene.seed, camera, part, axis)) - 1;
  return error;
}

}  // namespace

double nominal_position_m(const Scene& scene) {
  const double usual = kCarPositionM * std::min(1.0, scene.rig.vehicle.length_m / kCarLengthM);
  return scene.nominal.position_m.value_or(usual);
}

geometry::Rig nominal_rig(const Scene& scene) {
  geometry::Rig rig = scene.rig;
  rig.calibration.clear();
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    geometry::Rigid3& pose = rig.cameras[i].vehicle_from_camera;
    const Eigen::Vector3d turn = geometry::radians(scene.nominal.rotation_deg) * error(scene, i, kRotation);
    if (!turn.isZero()) pose.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.rotation;
    pose.translation += nominal_position_m(scene) * error(scene, i, kPosition);
  }
  return rig;
}

}  // namespace svchain::scene
