#pragma once
// Finds a corner of a chart to a fraction of a pixel, near where a predicted pose puts it. The picture's own
// pixels are compared with a model of the corner (corner_pattern.h) whose edges are straight on the ground
// and so bend in the picture as the lens bends them (corner_window.h); Levenberg and Marquardt's method moves
// the model. Pure functions: any thread. Grey pictures are CV_8UC1 or CV_32FC1, levels 0..255; what is at 255
// is taken to be clipped.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/lens.h"

namespace svchain::calibration {

struct CornerGuess {
  Eigen::Vector2d pixel;
  /// Where the pixel moves along the chart's edges, as far as the corner reaches (ChartCorner::reach_m).
  Eigen::Vector2d along_x_px;
  Eigen::Vector2d along_y_px;
  DarkQuarters dark = 0;
};

struct FittedCorner {
  Eigen::Vector2d pixel;
  Eigen::Matrix2d covariance_px2;  // by what the model leaves unexplained
  double contrast = 0;             // grey levels between light and dark
  double misfit = 0;               // rms of what is left unexplained / contrast
};

/// The corner near the guess. Finds it where the guess is off by up to 0.18 of the shorter edge (and 4 px),
/// its edges by 15 degrees and a quarter of their lengths. Nothing where there is no such corner: too little
/// contrast, another pattern, light for dark, or where the picture or the lens ends too near.
std::optional<FittedCorner> fit_corner(const cv::Mat& grey, const geometry::Lens& lens,
                                       const CornerGuess& guess);

}  // namespace svchain::calibration
