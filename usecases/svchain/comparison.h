#pragma once
// The paper's comparison in figures: how differently bright two cameras show what they share, and how far
// apart they put it, run by run. Plain values and pure functions.

#include <array>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/rig.h"
#include "algorithms/json/fault.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::program {

/// A run's last composite, and what it was made from.
struct LastComposite {
  cv::Mat view;                   // BGR
  std::vector<std::byte> lut;     // geometric
  std::array<cv::Mat, 4> frames;  // BGR; front, right, rear, left
  synthesis::ToneMapping tone_mapping;
};

/// A feature of the ground in the images of two neighbours.
struct SharedFeature {
  Eigen::Vector2d pixel_a, pixel_b;
};
/// By overlap: of camera i and the next one clockwise.
using SharedFeatures = std::array<std::vector<SharedFeature>, 4>;

/// What neighbours have in common, by registration (algorithms/registration/alignment.h) from where the rig
/// has the cameras: matches that agree when they are left out of the fit. Too few in an overlap: none.
SharedFeatures shared_features(const geometry::Rig& rig, const std::array<cv::Mat, 4>& frames);

struct OverlapFigures {
  std::optional<double> difference_levels;  // mean of |a - b| over pixels' blocks and channels
  size_t blocks = 0;
  std::optional<double> misalignment_px;  // median, of the view
  size_t features = 0;                    // that it is the median of
};

struct CompositeFigures {
  double metres_per_px = 0;
  std::array<OverlapFigures, 4> overlaps;  // front-right, right-rear, rear-left, left-front

  /// Means over the overlaps that have one.
  std::optional<double> difference_levels() const;
  std::optional<double> misalignment_px() const;
};

/// By the composite's own LUT, whichever way it was made. Throws std::invalid_argument where a camera's frame
/// is missing.
CompositeFigures figures_of(const LastComposite& composite, const SharedFeatures& features);

nlohmann::json figures_json(const CompositeFigures& figures);

struct NamedFigures {
  std::string name;
  CompositeFigures figures;
};
/// For people: a line for each.
std::string figures_table(const std::vector<NamedFigures>& compared);

}  // namespace svchain::program
