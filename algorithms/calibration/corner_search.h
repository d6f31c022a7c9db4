#pragma once
// The first half of a calibration: from pictures to corners with names and a first guess of all poses. Pure.

#include "algorithms/calibration/calibration.h"
#include "algorithms/calibration/fragments.h"
#include "algorithms/calibration/seen_corners.h"

namespace svchain::calibration {

struct NamedCorners {
  std::vector<SeenCorner> corners;
  Estimate estimate;
  std::vector<bool> placed;         // charts that have a pose or were seen
  std::vector<int> contradictions;  // by camera: pieces that are a posed chart's by their pattern, elsewhere
  std::vector<int> unexplained;     // by camera: pieces that do not lie on the ground as squares
};

/// What a camera's picture shows of the charts, laid on the ground by the camera's pose and, where what is
/// found sets that right by much, once more by the better one; where somebody has pointed at its corners,
/// those.
std::vector<Fragment> fragments_of(size_t camera, const cv::Mat& grey, const CalibrationInput& input,
                                   const std::vector<ChartPattern>& patterns);

/// `fragments`: of each camera.
NamedCorners name_corners(const CalibrationInput& input, std::vector<std::vector<Fragment>> fragments,
                          const std::vector<ChartPattern>& patterns);

/// What is known of a camera's pose before any picture is looked at.
PosePrior pose_prior(const geometry::Camera& camera, const NominalTolerance& tolerance);

}  // namespace svchain::calibration
