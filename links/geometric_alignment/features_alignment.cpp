#include "links/geometric_alignment/features_alignment.h"

#include "algorithms/calibration/calibration.h"
#include "algorithms/geometry/angles.h"

namespace svchain {

namespace {

/// The sigma of what may be off evenly up to 1.
constexpr double kEvenToSigma = 0.58;
/// The lens is known and the camera rigid, so the matrices may hardly be anything but poses.
constexpr double kStretch = 1e-4;

nlohmann::json accuracy_json(const registration::Alignment& found, double metres_per_px, bool with_times) {
  nlohmann::json json = {{"metres_per_px", metres_per_px}};
  for (const auto& overlap : found.overlaps) {
    json["overlaps"][geometry::kCameraNames[overlap.a] + "-" + geometry::kCameraNames[overlap.b]] = {
        {"matches", overlap.matches.size()},
        {"inliers", overlap.inliers()},
        {"rms_px", overlap.residual_rms_px()},
        {"held_out_rms_px", overlap.held_out_rms_px()}};
  }
  if (!with_times) return json;
  for (const auto& stage : found.times) json["stages_ms"][stage.name] = stage.ms;
  return json;
}

}  // namespace

registration::AlignmentTask alignment_task(const geometry::Rig& nominal,
                                           const std::array<cv::Mat, 4>& pictures) {
  const auto tape = calibration::tape_tolerance(nominal.vehicle);
  registration::AlignmentTask task;
  task.frames = pictures;
  task.vehicle = nominal.vehicle;
  task.view.metres_per_px = geometry::default_metres_per_px(nominal.vehicle, task.view.size_px);
  task.start = {kEvenToSigma * geometry::radians(tape.rotation_deg), kEvenToSigma * tape.position_m,
                kStretch};
  for (size_t i = 0; i < task.cameras.size(); ++i) {
    const geometry::Camera& camera = nominal.cameras[i];
    task.cameras[i] = {camera.lens, camera.image_size_px,
                       geometry::ray_from_ground(camera.vehicle_from_camera)};
  }
  return task;
}

GroundAlignment align_by_features(const geometry::Rig& nominal, const std::array<cv::Mat, 4>& pictures,
                                  bool with_times) {
  GroundAlignment aligned{nominal, {}, {}, {}};
  const registration::AlignmentTask task = alignment_task(nominal, pictures);
  const auto found = registration::align(task);
  if (!found) {
    for (const Fault& fault : found.error()) aligned.reasons.push_back(fault.file + ": " + fault.message);
    return aligned;
  }
  aligned.rays = found->ray_from_ground;
  aligned.accuracy = accuracy_json(*found, task.view.metres_per_px, with_times);
  return aligned;
}

}  // namespace svchain
