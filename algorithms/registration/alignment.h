#pragma once
// The paper's geometric alignment in two dimensions: four frames and four perspective matrices that are
// nearly right go in, four matrices under which neighbours show the ground alike come out. Lens correction
// and initial perspective, Harris corners in the overlaps, BRIEF, matching with rejection, then all four
// matrices at once, from coarse to fine. It needs no chart whose place is known; place and scale of the whole
// are those of the start. Pure but for the clock that times the stages.

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "algorithms/geometry/view.h"
#include "algorithms/json/fault.h"
#include "algorithms/registration/perspective.h"
#include "algorithms/registration/stage_clock.h"

namespace svchain::registration {

struct AlignmentTask {
  std::array<cv::Mat, 4> frames;        // front, right, rear, left; 8 bits, BGR or grey
  std::array<GroundCamera, 4> cameras;  // with the matrices to start from
  geometry::Vehicle vehicle;
  geometry::View view;    // the ground that is aligned, and the scale in whose pixels residuals are
  Uncertainty start;      // of the matrices
  bool hold_out = false;  // every second match stays out of the fit and is only measured
};

struct Match {
  Eigen::Vector2d pixel_a;
  Eigen::Vector2d pixel_b;
  Eigen::Vector2d ground_m;  // midway between where both put it
  double residual_px = 0;    // between where both put it, in px of the view
  bool inlier = false;
  bool held_out = false;
};

/// The matches of camera `a` and the next one clockwise, `b`.
struct OverlapAlignment {
  size_t a = 0;
  size_t b = 0;
  std::vector<Match> matches;

  /// Of the inliers that were fitted, or of those held out; 0 where there are none.
  double rms_px(bool held_out) const;
};

struct Alignment {
  Perspectives ray_from_ground;
  std::array<OverlapAlignment, 4> overlaps;
  std::vector<StageTime> times;
};

/// Faults: a frame that is not as large as its camera's image says, a singular matrix, an overlap with too few matches.
Result<Alignment> align(const AlignmentTask& task);

}  // namespace svchain::registration
