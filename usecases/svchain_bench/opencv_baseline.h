#pragma once
// The composite as one would make it of OpenCV's parts, to measure synthesis against ("B"): for each camera
// its rectangle of the composite by cv::remap with fixed-point maps (CV_16SC2), its tone curves by cv::LUT,
// and an integer blend into what is there. The maps and weights are those of a geometric LUT, so the result
// differs from synthesis by rounding alone: up to 2 levels, times the slope of the curves. It keeps no
// statistics and undoes no falloff. One thread at a time but for run_rows; cv::setNumThreads is the caller's.

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/tone_mapping.h"
#include "usecases/svchain_bench/camera_maps.h"

namespace svchain::bench {

class OpencvBaseline {
 public:
  /// Copies what it needs.
  OpencvBaseline(const synthesis::GeometricLut& lut, const synthesis::ToneMapping& tone_mapping);

  /// From four BGR frames. `out` is the BGR composite, of the view's size, black where nothing is written.
  void run(const std::array<cv::Mat, 4>& bgr, cv::Mat& out);
  /// A strip of the composite. Different threads may do strips that have no row in common.
  void run_rows(const cv::Range& rows, const std::array<cv::Mat, 4>& bgr, cv::Mat& out);
  /// From four frames in NV12 (one plane of 3/2 the height), each converted by cv::cvtColor first.
  void run_nv12(const std::array<cv::Mat, 4>& nv12, cv::Mat& out);

 private:
  struct Camera {
    cv::Rect place;        // in the composite
    cv::Mat xy, fraction;  // CV_16SC2, CV_16UC1
    cv::Mat curves;        // 1 x 256, CV_8UC3
    cv::Mat weights;       // CV_8UC3: what the camera takes of what is there
    cv::Mat samples;       // room for its part
  };

  std::array<Camera, 4> cameras_;
  std::array<cv::Mat, 4> converted_;
  Background background_;
};

}  // namespace svchain::bench
