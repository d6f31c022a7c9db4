#pragma once
// Pieces of charts found in one camera's picture, each with a plane of its own, not yet told which chart they
// belong to: pieces of lattice where dark squares touch, single squares, tags. Plain values; pure.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/rig.h"

namespace svchain::calibration {

struct FragmentCorner {
  Eigen::Vector2d place_m = {0, 0};  // on the fragment's own plane, axes along edges
  DarkQuarters dark = 0;             // by those axes
  Eigen::Vector2d pixel = {0, 0};
  Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Identity();
};

/// What the corners are, where somebody has pointed at them.
struct KnownCorners {
  size_t chart = 0;
  std::vector<int> corner;  // none: it is not known
};

struct Fragment {
  std::vector<FragmentCorner> corners;
  std::optional<int> tag_id = {};
  KnownCorners known = {};
};

/// What of these charts is in a picture (CV_8UC1), largest first. The camera's pose may be some degrees and a
/// tenth of its height wrong.
std::vector<Fragment> find_fragments(const geometry::Camera& camera, const cv::Mat& grey,
                                     const std::vector<Chart>& charts);

/// The same pieces as far as their patterns tell, their corners not fitted and without pixels: quick.
std::vector<Fragment> find_patterns(const geometry::Camera& camera, const cv::Mat& grey,
                                    const std::vector<Chart>& charts);

}  // namespace svchain::calibration
