#include "usecases/svchain/calibration_table.h"

#include <cstdio>

namespace svchain::program {

namespace {

using calibration::Calibration;
using calibration::CameraAccuracy;

std::string lens_text(const CameraAccuracy& camera) {
  if (camera.lens_change_px < 0.05) return "kept";
  char text[40];
  std::snprintf(text, sizeof text, "refined by %.1f px", camera.lens_change_px);
  return text;
}

std::string camera_line(const std::string& name, const CameraAccuracy& camera) {
  char text[160];
  std::snprintf(text, sizeof text, "%-8s %7.2f %9s %9.3f %9.1f %10.2f %8.2f %8.2f  %s\n", name.c_str(),
                camera.rms_px, (std::to_string(camera.inliers) + "/" + std::to_string(camera.points)).c_str(),
                camera.sigma_rotation_deg.maxCoeff(), camera.sigma_translation_mm.maxCoeff(),
                camera.ground_rms_cm, camera.ground_sigma_near_cm, camera.ground_sigma_far_cm,
                lens_text(camera).c_str());
  return text;
}

}  // namespace

std::string calibration_table(const Calibration& calibration) {
  std::string table = "camera    rms px   corners sigma deg  sigma mm  ground cm  near cm   far cm  lens\n";
  for (size_t c = 0; c < calibration.cameras.size(); ++c)
    table += camera_line(geometry::kCameraNames[c], calibration.cameras[c]);
  table += "overlaps:";
  std::string separator = " ";
  for (size_t c = 0; c < geometry::kCameraNames.size(); ++c) {
    const auto& names = geometry::kCameraNames;
    const auto overlap = calibration.overlaps.find(names[c] + "-" + names[(c + 1) % names.size()]);
    if (overlap == calibration.overlaps.end()) continue;
    char text[80];
    std::snprintf(text, sizeof text, "%s %.2f cm (%d corners)", overlap->first.c_str(),
                  overlap->second.rms_cm, overlap->second.points);
    table += separator + text;
    separator = ", ";
  }
  return table + "\n";
}

Faults reasons_of(const Calibration& calibration) {
  Faults faults;
  for (size_t c = 0; c < calibration.cameras.size(); ++c) {
    for (const auto& reason : calibration.cameras[c].reasons)
      faults.push_back({geometry::kCameraNames[c], {}, {}, reason});
  }
  for (const auto& reason : calibration.reasons) faults.push_back({{}, {}, {}, reason});
  return faults;
}

}  // namespace svchain::program
