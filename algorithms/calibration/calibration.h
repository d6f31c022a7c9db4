#pragma once
// Geometric alignment by charts: from four pictures, what lies on the ground and a rough rig to a rig that is
// right to the centimetre, and how far it can be trusted. The paper's way (corners found automatically, DLT,
// orthogonal projection, RANSAC, Levenberg-Marquardt through the lens), then everything unknown refined
// jointly. Plain values; pure: the same pictures give the same rig.

#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/rig.h"

namespace svchain::calibration {

/// Corners left out of the fit, by their index within the chart; results then are about those.
enum class HoldOut { kNone, kEven, kOdd };

/// A corner somebody has pointed at in a picture, instead of having it found.
struct ClickedCorner {
  size_t camera = 0;
  size_t chart = 0;
  int corner = 0;
  Eigen::Vector2d pixel = {0, 0};
};

/// How well the nominal poses are known, per axis of the vehicle.
struct NominalTolerance {
  double rotation_deg = 0;
  double position_m = 0;
};
/// Of a rig measured by tape: 3 degrees, and 5 cm on a car.
NominalTolerance tape_tolerance(const geometry::Vehicle& vehicle);

struct CalibrationInput {
  geometry::Rig nominal;
  std::optional<NominalTolerance> tolerance = {};  // missing: measured by tape
  std::vector<Chart> charts;
  std::vector<cv::Mat> pictures;  // front, right, rear, left; BGR or grey, 8 bits; none where all is clicked
  HoldOut hold_out = HoldOut::kNone;
  std::vector<ClickedCorner> clicked;
};

enum class CornerState { kFitted, kHeldOut, kRejected, kNotFound };

/// A corner that a camera should see, by the calibration.
struct CornerRecord {
  size_t camera = 0;
  size_t chart = 0;
  int corner = 0;
  CornerState state = CornerState::kNotFound;
  Eigen::Vector2d predicted_px = {0, 0};
  Eigen::Vector2d found_px = {0, 0};  // unless it was not found
};

struct CameraAccuracy {
  double rms_px = 0;  // over inliers
  int points = 0;     // found
  int inliers = 0;
  Eigen::Vector3d sigma_rotation_deg = {0, 0, 0};    // about the vehicle's axes
  Eigen::Vector3d sigma_translation_mm = {0, 0, 0};  // along them
  double ground_rms_cm = 0;                          // corners on the ground against where they are
  double ground_across_rms_cm = 0;                   // the part of it across the line of sight
  /// By the covariance, half a metre and three metres beside a car; a motion common to all cameras apart.
  double ground_sigma_near_cm = 0;
  double ground_sigma_far_cm = 0;
  double lens_change_px = 0;         // RMS over the corners; 0: the lens was kept
  std::vector<std::string> reasons;  // why it is rejected; none: accepted
};

struct OverlapAccuracy {
  double rms_cm = 0;  // between the places of the same corner by both cameras
  int points = 0;
};

struct Calibration {
  geometry::Rig rig;
  std::vector<Chart> charts;                        // all of them posed, as far as they were seen
  std::vector<CameraAccuracy> cameras;              // front, right, rear, left
  std::map<std::string, OverlapAccuracy> overlaps;  // "front-right", ...
  std::vector<CornerRecord> corners;
  std::vector<std::string> reasons;  // why the whole is rejected, cameras apart
  std::vector<std::pair<std::string, double>> stage_ms;

  bool accepted() const;
};

/// Throws std::invalid_argument where the pictures are not four of the rig's sizes.
Calibration calibrate(const CalibrationInput& input);

}  // namespace svchain::calibration
