#pragma once
// The set rendered_exact: pictures rendered by somebody else, with the exact calibration they were rendered
// by. Reads files; otherwise pure.

#include <array>
#include <filesystem>

#include "algorithms/calibration/calibration.h"
#include "algorithms/json/fault.h"

namespace svchain::accuracy {

struct RenderedExact {
  geometry::Rig given;
  std::vector<calibration::Chart> charts;
  std::vector<cv::Mat> pictures;
};
Result<RenderedExact> read_rendered_exact(const std::filesystem::path& folder);

struct RenderedCamera {
  int corners = 0;
  double ours_px = 0;   // RMS of all corners found, by our calibration
  double given_px = 0;  // of the same corners, by the given one
  double rotation_deg = 0;
  double translation_mm = 0;
};

struct RenderedResult {
  calibration::Calibration made;
  std::array<RenderedCamera, 4> cameras;
};
/// Calibrated from the given poses moved by up to 5 cm along and 3 degrees about each axis.
RenderedResult calibrate_rendered(const RenderedExact& set);

}  // namespace svchain::accuracy
