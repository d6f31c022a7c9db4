#pragma once
// A picture's pixels around a corner, at places where straight edges on the ground are straight: rays through
// the pixels meet the plane tangent to the window's middle ray, scaled so that next to the middle a place is
// the pixel's offset from there. Plain value.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "algorithms/calibration/corner_fit.h"
#include "algorithms/geometry/lens.h"

namespace svchain::calibration {

struct CornerWindow {
  struct Pixel {
    Eigen::Vector2d place_px;
    double grey;
  };
  std::vector<Pixel> pixels;
  Eigen::Vector3d middle;              // unit ray
  Eigen::Matrix<double, 3, 2> across;  // per px

  Eigen::Vector3d ray_at(const Eigen::Vector2d& place_px) const { return middle + across * place_px; }
};

/// Half of a window, in parts of the corner's reach along each edge, and how far it goes at most.
inline constexpr double kWindowShare = 0.6;
inline constexpr double kWindowRadiusPx = 20;

/// The pixels around the guess that are within half a window along both edges and within the radius. Nothing
/// where some are not in the picture or not within the lens's reach, or where the corner is too small to have
/// enough of them.
std::optional<CornerWindow> corner_window(const cv::Mat& grey, const geometry::Lens& lens,
                                          const CornerGuess& guess, double radius_px);

}  // namespace svchain::calibration
