#pragma once
// What a calibration is compared with: the ways of hobby projects, at their best. They are given what they do
// not find by themselves: which corner is which, and where each is to the nearest pixel. Pure functions.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/rig.h"

namespace svchain::accuracy {

struct PlainCorner {
  Eigen::Vector2d ground_m;
  Eigen::Vector2d pixel;
};

/// By camera: the corners of posed charts as cv::cornerSubPix finds them in the distorted picture, started at
/// the true pixel rounded to a whole one, in a window of up to 11 x 11 px that holds no other corner.
std::vector<std::vector<PlainCorner>> plain_corners(const geometry::Rig& truth,
                                                    const std::vector<calibration::Chart>& charts,
                                                    const std::vector<cv::Mat>& pictures);

/// Each camera by itself, its pose refined through the lens (Levenberg-Marquardt) from the nominal one.
geometry::Rig poses_refined(geometry::Rig nominal, const std::vector<std::vector<PlainCorner>>& corners);

/// Each camera by itself, its picture undistorted to an ideal pinhole's (what is within 80 degrees of the
/// axis), from there to the ground by cv::findHomography over all corners.
class PlainHomography {
 public:
  PlainHomography(geometry::LensPtr lens, const std::vector<PlainCorner>& corners);

  std::optional<Eigen::Vector2d> ground_of(const Eigen::Vector2d& pixel) const;

 private:
  geometry::LensPtr lens_;
  Eigen::Matrix3d ground_from_ideal_;
};

}  // namespace svchain::accuracy
