#include "usecases/svchain_accuracy/simulated_set.h"

#include <algorithm>
#include <cstdio>

#include "usecases/svchain_accuracy/plain_calibration.h"
#include "usecases/svchain_accuracy/reasons.h"
#include "usecases/svchain_accuracy/trial.h"

namespace svchain::accuracy {

namespace {

using calibration::Calibration;

std::string text_of(const std::string& name, const Outcome& outcome) {
  char text[160];
  std::snprintf(text, sizeof text, "%s %s %.4f deg %.2f mm ground %.2f mm %.1f sigmas %s", name.c_str(),
                outcome.accepted ? "accepted" : "REJECTED", outcome.worst.rotation_deg,
                outcome.worst.translation_mm, outcome.worst.ground_mm, outcome.worst.sigmas,
                outcome.reasons.substr(0, 60).c_str());
  return text;
}

double worst_homography_ground_mm(const geometry::Rig& truth,
                                  const std::vector<std::vector<PlainCorner>>& corners) {
  double worst = 0;
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    const PlainHomography homography(truth.cameras[c].lens, corners[c]);
    worst = std::max(worst, ground_rms_mm(truth, c, [&](const Eigen::Vector2d& pixel) {
                       return homography.ground_of(pixel);
                     }));
  }
  return worst;
}

}  // namespace

SetResult measure(const SimulatedSet& set) {
  const scene::Scene scene = trial_scene(set.vehicle, set.lens_model, set.seed);
  const geometry::Rig& truth = scene.rig;
  calibration::CalibrationInput input = input_of(scene);
  SetResult result;
  result.set = set;
  const auto corners = plain_corners(truth, input.charts, input.pictures);
  result.refined = worst_of(pose_errors(truth, poses_refined(input.nominal, corners)));
  result.homography_ground_mm = worst_homography_ground_mm(truth, corners);

  const Calibration posed = calibrate(input);
  result.posed = {posed.accepted(), reasons_of(posed),
                  worst_of(pose_errors(truth, posed.rig, posed.cameras))};
  input.charts = unposed(input.charts);
  const Calibration free = calibrate(input);
  const geometry::Rig moved = in_best_place(truth, free.rig);
  result.unposed = {free.accepted(), reasons_of(free), worst_of(pose_errors(truth, moved, free.cameras))};
  result.unposed_sigmas_moved = result.unposed.worst.sigmas;
  result.unposed.worst.sigmas = worst_of(pose_errors(truth, free.rig, free.cameras)).sigmas;
  return result;
}

std::string text_of(const SetResult& result) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%s %s seed %d: refined %.4f deg %.2f mm ground %.2f mm, homography %.2f mm",
                result.set.vehicle.c_str(), result.set.lens_model.c_str(), static_cast<int>(result.set.seed),
                result.refined.rotation_deg, result.refined.translation_mm, result.refined.ground_mm,
                result.homography_ground_mm);
  return text + std::string("; ") + text_of("posed", result.posed) + "; " +
         text_of("unposed", result.unposed);
}

}  // namespace svchain::accuracy
