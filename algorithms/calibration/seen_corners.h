#pragma once
// Corners that cameras have been found to see, and everything refined by them. How much to believe of a
// corner is told by what the others leave unexplained; what is somewhat off counts less (Huber, Ann. Math.
// Stat. 35(1), 1964), what is far off not at all. Pure.

#include <vector>

#include "algorithms/calibration/identity.h"
#include "algorithms/calibration/joint_refinement.h"

namespace svchain::calibration {

struct SeenCorner {
  size_t camera = 0;
  size_t chart = 0;
  int corner = 0;
  Eigen::Vector2d pixel = {0, 0};
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Identity();  // of the corner's fit
  bool held_out = false;
  bool rejected = false;
};

/// Cameras and charts as far as they are known.
struct Estimate {
  std::vector<UnknownCamera> cameras;
  std::vector<UnknownChart> charts;
};

struct FittedEstimate {
  JointSolution solution;
  std::vector<double> rms_px;      // by camera, of the corners that agree
  std::vector<double> scatter_px;  // the same with the fit's own freedom allowed for
};

CornerSighting sighting_of(const SeenCorner& seen, const std::vector<ChartPattern>& patterns);

/// Refines everything by the corners that are not held out and marks all that do not agree, held out or not.
/// Lenses are kept unless they have a prior.
FittedEstimate fit(const Estimate& start, std::vector<SeenCorner>& corners,
                   const std::vector<ChartPattern>& patterns);

}  // namespace svchain::calibration
