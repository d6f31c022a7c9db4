#pragma once
// Where exactly a patch of one ground picture lies in another: the shift that makes both most alike but for
// gain and offset, by the inverse compositional method (Baker and Matthews, IJCV 56(3), 2004). A camera
// smears what it sees far off along its line of sight, each its own way, which would shift all that is not
// symmetrical: so each patch is first smeared as the other one is. Pure.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace svchain::registration {

/// A ground picture (grey, CV_32F), and what one pixel of its camera covers there, as a matrix from pixels of
/// the camera's image to pixels of the picture.
struct SmearedPicture {
  const cv::Mat& picture;
  Eigen::Matrix2d picture_from_image;
};

/// Shift from `at` in `a` to its like in `b`, sought from `start` (whole pixels) on and at most kNudgePx from
/// it. Nothing where the patch reaches beyond what is `seen` (CV_8U), is flat, runs away or ends unlike.
std::optional<Eigen::Vector2d> aligned_patch(const SmearedPicture& a, const SmearedPicture& b,
                                             const cv::Mat& seen, const cv::Point& at,
                                             const cv::Point& start);

inline constexpr int kNudgePx = 5;

}  // namespace svchain::registration
