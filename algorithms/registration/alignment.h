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
  geometry::View view;  // the ground that is aligned, and the scale in whose pixels residuals are
  Uncertainty start;    // of the matrices
  size_t folds = 4;     // for what is held out: each of so many parts in turn (2: halves)
};

struct Match {
  Eigen::Vector2d pixel_a;
  Eigen::Vector2d pixel_b;
  Eigen::Vector2d ground_m;  // midway between where both put it
  double residual_px = 0;    // between where both put it, in px of the view
  double held_out_px = 0;    // the same under matrices that were fitted without this match and its fold
  bool inlier = false;       // by the held-out residual
};

/// The matches of camera `a` and the next one clockwise, `b`.
struct OverlapAlignment {
  size_t a = 0;
  size_t b = 0;
  std::vector<Match> matches;

  size_t inliers() const;
  /// Of the inliers, root mean square; 0 where there are none.
  double residual_rms_px() const;
  double held_out_rms_px() const;
};

struct Alignment {
  Perspectives ray_from_ground;
  std::array<OverlapAlignment, 4> overlaps;
  std::vector<StageTime> times;
};

/// An overlap in which fewer matches agree tells nothing.
inline constexpr size_t kFewestMatches = 8;

/// Faults: a frame that is not what its camera takes, a singular matrix, an uncertainty that is not positive;
/// overlaps with too few matches, which tell what was found there.
Result<Alignment> align(const AlignmentTask& task);
/// The same, however few matches there are: for whoever judges them himself.
Result<Alignment> align_by_any_matches(const AlignmentTask& task);

}  // namespace svchain::registration
