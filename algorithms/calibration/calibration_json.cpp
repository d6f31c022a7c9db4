#include "algorithms/calibration/calibration_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "algorithms/json/layout.h"

namespace svchain::calibration {

namespace {

using nlohmann::ordered_json;

/// Finer than anything that is measured here.
double rounded(double value) {
  return std::round(1e6 * value) / 1e6;
}

ordered_json vector_json(const Eigen::Vector3d& v) {
  return {rounded(v.x()), rounded(v.y()), rounded(v.z())};
}

ordered_json pixel_json(const Eigen::Vector2d& pixel) {
  return {rounded(pixel.x()), rounded(pixel.y())};
}

ordered_json fit_json(const CameraAccuracy& camera) {
  return {{"rms_px", rounded(camera.rms_px)},
          {"points", camera.points},
          {"inliers", camera.inliers},
          {"sigma_rotation_deg", vector_json(camera.sigma_rotation_deg)},
          {"sigma_translation_mm", vector_json(camera.sigma_translation_mm)},
          {"accepted", camera.reasons.empty()}};
}

ordered_json camera_json(const CameraAccuracy& camera) {
  ordered_json item = fit_json(camera);
  item.update({{"ground_rms_cm", rounded(camera.ground_rms_cm)},
               {"ground_across_rms_cm", rounded(camera.ground_across_rms_cm)},
               {"ground_sigma_near_cm", rounded(camera.ground_sigma_near_cm)},
               {"ground_sigma_far_cm", rounded(camera.ground_sigma_far_cm)},
               {"lens_change_px", rounded(camera.lens_change_px)},
               {"reasons", camera.reasons}});
  return item;
}

ordered_json cameras_json(const Calibration& calibration, ordered_json (*one)(const CameraAccuracy&)) {
  ordered_json cameras = ordered_json::object();
  for (size_t c = 0; c < calibration.cameras.size(); ++c)
    cameras[geometry::kCameraNames[c]] = one(calibration.cameras[c]);
  return cameras;
}

/// In the cameras' order, clockwise from the front.
ordered_json overlaps_json(const Calibration& calibration) {
  const auto& names = geometry::kCameraNames;
  ordered_json overlaps = ordered_json::object();
  for (size_t c = 0; c < names.size(); ++c) {
    const auto found = calibration.overlaps.find(names[c] + "-" + names[(c + 1) % names.size()]);
    if (found != calibration.overlaps.end())
      overlaps[found->first] = {{"rms_cm", rounded(found->second.rms_cm)}, {"points", found->second.points}};
  }
  return overlaps;
}

/// As they hold for this vehicle and how well its rig is known.
ordered_json limits_json(const AcceptanceLimits& limits, const CalibrationInput& input) {
  const double scale = scale_of(input.nominal.vehicle);
  const NominalTolerance nominal = input.tolerance.value_or(tape_tolerance(input.nominal.vehicle));
  return {{"least_inliers", limits.least_inliers},
          {"least_inlier_share", limits.least_inlier_share},
          {"most_rms_px", limits.most_rms_px},
          {"most_ground_sigma_near_cm", rounded(scale * limits.most_ground_sigma_near_cm)},
          {"most_ground_sigma_far_cm", rounded(scale * limits.most_ground_sigma_far_cm)},
          {"most_ground_rms_cm", rounded(scale * limits.most_ground_rms_cm)},
          {"most_overlap_rms_cm", rounded(scale * limits.most_overlap_rms_cm)},
          {"most_turn_from_nominal_deg", rounded(limits.most_turn_from_nominal * nominal.rotation_deg)},
          {"most_shift_from_nominal_m", rounded(limits.most_shift_from_nominal * nominal.position_m)},
          {"most_lens_change_px", limits.most_lens_change_px}};
}

ordered_json corner_json(const CornerRecord& corner, const std::vector<Chart>& charts) {
  ordered_json item = {{"camera", geometry::kCameraNames[corner.camera]},
                       {"chart", charts[corner.chart].name},
                       {"corner", corner.corner},
                       {"state", corner_state_names()[static_cast<size_t>(corner.state)]}};
  if (corner.state != CornerState::kNotFound) item["pixel_px"] = pixel_json(corner.found_px);
  item["predicted_px"] = pixel_json(corner.predicted_px);
  return item;
}

ordered_json corners_json(const Calibration& calibration) {
  ordered_json corners = ordered_json::array();
  for (const auto& corner : calibration.corners) corners.push_back(corner_json(corner, calibration.charts));
  return corners;
}

ordered_json stages_json(const Calibration& calibration) {
  ordered_json stages = ordered_json::object();
  for (const auto& [stage, ms] : calibration.stage_ms) stages[stage] = rounded(ms);
  return stages;
}

}  // namespace

const std::vector<std::string>& hold_out_names() {
  static const std::vector<std::string> kNames = {"none", "even", "odd"};
  return kNames;
}

const std::vector<std::string>& corner_state_names() {
  static const std::vector<std::string> kNames = {"fitted", "held_out", "rejected", "not_found"};
  return kNames;
}

const std::vector<std::string>& report_keys() {
  static const std::vector<std::string> kKeys = {"date",     "accepted", "reasons",   "hold_out", "cameras",
                                                 "overlaps", "limits",   "stages_ms", "charts",   "corners"};
  return kKeys;
}

std::string rig_part(const Calibration& calibration, const std::string& date) {
  const ordered_json part = {{"date", date},
                             {"cameras", cameras_json(calibration, fit_json)},
                             {"overlaps", overlaps_json(calibration)}};
  return part.dump();
}

std::string report_text(const CalibrationInput& input, const AcceptanceLimits& limits,
                        const Calibration& calibration, const std::string& date) {
  const ordered_json report = {{"date", date},
                               {"accepted", calibration.accepted()},
                               {"reasons", calibration.reasons},
                               {"hold_out", hold_out_names()[static_cast<size_t>(input.hold_out)]},
                               {"cameras", cameras_json(calibration, camera_json)},
                               {"overlaps", overlaps_json(calibration)},
                               {"limits", limits_json(limits, input)},
                               {"stages_ms", stages_json(calibration)},
                               {"charts", ordered_json::parse(charts_text(calibration.charts))["charts"]},
                               {"corners", corners_json(calibration)}};
  return json::file_text(report);
}

}  // namespace svchain::calibration
