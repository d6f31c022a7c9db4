#include <cstdio>

#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/real_tables.h"
#include "usecases/svchain_accuracy/rendered_exact.h"

namespace svchain::accuracy {

namespace {

constexpr double kLimitPx = 0.1, kLimitDeg = 0.05, kLimitMm = 3;

std::string within(double value, double limit) {
  return figure(value) + " (" + met(value, limit) + ")";
}

std::string place_of(const geometry::Camera& camera) {
  const Eigen::Vector3d& at = camera.vehicle_from_camera.translation;
  char text[64];
  std::snprintf(text, sizeof text, "%.4f, %.4f, %.4f", at.x(), at.y(), at.z());
  return text;
}

/// The given poses of the front and rear cameras are the truth; those of the others are not.
Table against_given(const RenderedResult& result, const geometry::Rig& given) {
  Table table{{"camera", "corners", "px RMS, ours", "px RMS, given", "degrees from given", "mm from given",
               "place, m, ours", "place, m, given"},
              {}};
  for (size_t c = 0; c < 4; ++c) {
    const RenderedCamera& camera = result.cameras[c];
    const bool exact = c % 2 == 0;
    table.rows.push_back({geometry::kCameraNames[c], std::to_string(camera.corners),
                          within(camera.ours_px, exact ? kLimitPx : camera.given_px), figure(camera.given_px),
                          exact ? within(camera.rotation_deg, kLimitDeg) : figure(camera.rotation_deg),
                          exact ? within(camera.translation_mm, kLimitMm) : figure(camera.translation_mm),
                          place_of(result.made.rig.cameras[c]), place_of(given.cameras[c])});
  }
  return table;
}

}  // namespace

Section rendered(const std::filesystem::path& data) {
  const std::string title = "Pictures rendered by others";
  const auto set = read_rendered_exact(data / "rendered_exact");
  if (!set) return absent(title, set.error());
  const RenderedResult result = calibrate_rendered(*set);
  return {
      title,
      "Set `rendered_exact`: four 1920x1536 pictures and the calibration they came with. Ours starts from "
      "that, every camera moved by up to 5 cm along and 3 degrees about each axis. Limits for front and "
      "rear: " +
          figure(kLimitPx) + " px, " + figure(kLimitDeg) + " degrees, " + figure(kLimitMm) +
          " mm (in brackets: met). The given poses of the right and left cameras contradict their own "
          "pictures, as their px show; ours have to fit better than these. " +
          "The calibration was " + verdict(result.made) + ".\n",
      {against_given(result, set->given)}};
}

}  // namespace svchain::accuracy
