#pragma once
// The composite as it is usually written down first ("A"): like OpencvBaseline, but with maps in float (two
// CV_32FC1) and a blend in float. Differs from synthesis by rounding alone: up to 2 levels, times the slope
// of the curves. One thread; cv::setNumThreads is the caller's.

#include <array>
#include <opencv2/core/mat.hpp>

#include "usecases/svchain_bench/camera_maps.h"

namespace svchain::bench {

class OpencvFloatBaseline {
 public:
  /// Copies what it needs.
  OpencvFloatBaseline(const synthesis::GeometricLut& lut, const synthesis::ToneMapping& tone_mapping);

  /// From four BGR frames. `out` is the BGR composite, of the view's size, black where nothing is written.
  void run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out);

 private:
  struct Camera {
    cv::Rect place;   // in the composite
    cv::Mat x, y;     // CV_32FC1
    cv::Mat curves;   // 1 x 256, CV_8UC3
    cv::Mat weights;  // CV_32FC3, 0 to 1: what the camera takes of what is there
    cv::Mat samples;  // room for its part
  };

  std::array<Camera, 4> cameras_;
  Background background_;
};

}  // namespace svchain::bench
