#pragma once
// How far a calibrated rig is from the true one. Pure functions.

#include <functional>
#include <optional>
#include <vector>

#include "algorithms/calibration/calibration.h"
#include "algorithms/geometry/pose2.h"
#include "algorithms/geometry/rig.h"

namespace svchain::accuracy {

struct PoseError {
  double rotation_deg = 0;
  double translation_mm = 0;
  /// RMS over places on the ground: from a true place, through the true camera to a pixel, from there through
  /// the calibrated camera back to the ground. Of every place within 3 m of the vehicle (as much less as it
  /// is shorter than 4.8 m) that the true camera sees, 10 cm apart.
  double ground_mm = 0;
  double sigmas = 0;  // the largest of the six errors (about and along the vehicle's axes) in stated sigmas
};

/// The larger of each.
PoseError worst_of(const std::vector<PoseError>& errors);

/// By camera, without sigmas.
std::vector<PoseError> pose_errors(const geometry::Rig& truth, const geometry::Rig& calibrated);
/// The same with them.
std::vector<PoseError> pose_errors(const geometry::Rig& truth, const geometry::Rig& calibrated,
                                   const std::vector<calibration::CameraAccuracy>& stated);

/// The calibrated rig moved as a whole on the ground to where it explains the true one best: least squares
/// over the same places of all cameras.
geometry::Rig in_best_place(const geometry::Rig& truth, geometry::Rig calibrated);

/// Takes a pixel to the ground; nothing where it cannot.
using GroundOfPixel = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d& pixel)>;
/// PoseError::ground_mm of one camera, over the places that come back to the ground.
double ground_rms_mm(const geometry::Rig& truth, size_t camera, const GroundOfPixel& ground_of_pixel);

}  // namespace svchain::accuracy
