#include "tests/calibration/calibration_scene.h"

#include <algorithm>

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/geometry/angles.h"
#include "algorithms/scene/nominal_rig.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/scene/still_renderer.h"
#include "tests/test_data.h"

namespace svchain::testing {

namespace {

const scene::Scene& parking() {
  static const scene::Scene kParking = shipped_scene("parking");
  return kParking;
}

}  // namespace

scene::Scene shipped_scene(const std::string& name) {
  return *scene::read_scene(project_folder() / "configs/scenes" / (name + ".json"));
}

std::vector<cv::Mat> pictures_of(const scene::Scene& scene) {
  const scene::StillRenderer renderer(std::make_shared<const scene::World>(scene));
  std::vector<cv::Mat> pictures;
  for (size_t c = 0; c < scene.rig.cameras.size(); ++c) pictures.push_back(renderer.render(c, 0, 0));
  return pictures;
}

calibration::CalibrationInput parking_input() {
  static const std::vector<cv::Mat> kPictures = pictures_of(parking());
  calibration::CalibrationInput input;
  input.nominal = scene::nominal_rig(parking());
  input.charts = calibration::charts_of(parking());
  for (const auto& picture : kPictures) input.pictures.push_back(picture.clone());
  return input;
}

const geometry::Rig& parking_truth() {
  return parking().rig;
}

PoseError worst_error(const geometry::Rig& rig, const geometry::Rig& truth) {
  PoseError worst;
  for (size_t c = 0; c < rig.cameras.size(); ++c) {
    const auto& pose = rig.cameras[c].vehicle_from_camera;
    const auto& true_pose = truth.cameras[c].vehicle_from_camera;
    worst.rotation_deg =
        std::max(worst.rotation_deg, geometry::degrees(pose.rotation.angularDistance(true_pose.rotation)));
    worst.place_mm = std::max(worst.place_mm, 1000 * (pose.translation - true_pose.translation).norm());
  }
  return worst;
}

}  // namespace svchain::testing
