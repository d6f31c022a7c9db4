#pragma once
// The simulated car park as its four cameras see it, around it the default bowl, and what the CPU shows of
// it. Made once for all tests of a program.

#include <array>
#include <opencv2/core.hpp>

#include "algorithms/bowl/mesh_table.h"
#include "algorithms/bowl/viewpoint.h"
#include "algorithms/car/car_model.h"
#include "algorithms/colour/picture.h"
#include "algorithms/gl/bowl_renderer.h"
#include "algorithms/synthesis/tone_mapping.h"
#include "tests/bowl/owned_mesh.h"
#include "tests/has_gl.h"

namespace svchain::testing {

inline const Eigen::Vector2i kPicture(330, 405);

/// Four frames with the memory they are in.
struct Frames {
  std::array<cv::Mat, 4> memory;
  std::array<colour::Picture, 4> pictures;
};

struct Parking {
  Parking();
  bowl::Viewpoint preset(const std::string& name) const;

  geometry::Rig rig;
  bowl::BowlSurface surface;
  OwnedMesh mesh;
  car::CarModel car;
  Frames bgr;
};
const Parking& parking();

Frames in_yuv(const Frames& bgr, colour::PixelFormat format, colour::YuvEncoding encoding);

/// Curves that differ between cameras and channels; with or without falloff.
synthesis::ToneMapping smooth_tone_mapping(bool falloff);

/// A renderer of parking() with its mesh table.
std::unique_ptr<gl::BowlRenderer> renderer_of_parking(const gl::GlContext& context);
cv::Mat drawn(gl::BowlRenderer& renderer, const Frames& frames, const synthesis::ToneMapping& tone_mapping,
              const bowl::Viewpoint& viewpoint, float car_opacity = 0);

/// By the CPU. What of the picture the car covers is in `car_at`, where that is wanted.
cv::Mat expected(const Frames& frames, const synthesis::ToneMapping& tone_mapping,
                 const bowl::Viewpoint& viewpoint, float car_opacity = 0, cv::Rect* car_at = nullptr);

/// Of all channels, in levels.
double mean_difference(const cv::Mat& a, const cv::Mat& b);

}  // namespace svchain::testing
