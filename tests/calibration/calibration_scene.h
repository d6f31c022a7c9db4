#pragma once
// Simulated pictures to calibrate by, with the truth that calibrations are measured against.

#include <opencv2/core.hpp>

#include "algorithms/calibration/calibration.h"
#include "algorithms/scene/scene.h"

namespace svchain::testing {

/// A scene of configs/scenes.
scene::Scene shipped_scene(const std::string& name);

/// Its four pictures (16 rays a pixel: about a second).
std::vector<cv::Mat> pictures_of(const scene::Scene& scene);

/// Pictures, charts and the nominal rig of the shipped parking lot; the pictures are rendered once.
calibration::CalibrationInput parking_input();
const geometry::Rig& parking_truth();

struct PoseError {
  double rotation_deg = 0;
  double place_mm = 0;
};

/// Of the worst camera.
PoseError worst_error(const geometry::Rig& rig, const geometry::Rig& truth);

}  // namespace svchain::testing
