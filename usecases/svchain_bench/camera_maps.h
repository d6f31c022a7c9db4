#pragma once
// A geometric LUT taken apart into what programs made of OpenCV's parts work with: for each camera its
// rectangle of the composite with maps and weights. Pure functions; results own what they hold.

#include <opencv2/core/mat.hpp>

#include "algorithms/synthesis/geometric_lut.h"
#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::bench {

struct CameraMap {
  cv::Rect place;   // in the composite
  cv::Mat xy;       // CV_32FC2: where in the frame each pixel of the rectangle is sampled, px
  cv::Mat weights;  // CV_8UC3: what the camera takes of what cameras before it laid down, 255ths
  cv::Mat curves;   // 1 x 256, CV_8UC3
};

/// Cameras are to be laid down by number. Where the camera shows nothing, weights are 0 and samples cheap.
CameraMap camera_map(const synthesis::GeometricLut& lut, int camera,
                     const synthesis::ToneMapping& tone_mapping);

/// What the composite shows where no camera does.
struct Background {
  cv::Rect place;
  cv::Mat picture;  // CV_8UC3
};
Background background(const synthesis::GeometricLut& lut);

}  // namespace svchain::bench
