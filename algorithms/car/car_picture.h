#pragma once
// The car as a viewpoint shows it, kept so that a viewpoint that stands still costs one alpha blend a frame.
// Edges have four samples a pixel; lighting.h says how surfaces look and contact_shadow.h how dark the ground
// under them is. Owns the model and the picture. One thread at a time: `render` in one, `blend_over` and the
// readers in any between two renderings.

#include <opencv2/core/mat.hpp>

#include "algorithms/car/car_model.h"
#include "algorithms/car/contact_shadow.h"
#include "algorithms/car/lighting.h"
#include "algorithms/car/rasteriser.h"
#include "algorithms/car/viewpoint.h"

namespace svchain::car {

class CarPicture {
 public:
  /// The model stands on the ground of the vehicle's frame; the shadow is the vehicle's rectangle's.
  CarPicture(CarModel model, const geometry::Vehicle& vehicle, const Light& light = bright_day());

  /// Draws the car, `opacity` (0..1) times as dense as it is, shadow included. Whatever is out of sight or
  /// behind the eye is left out; an eye inside the car sees it from there. Allocates where the car has never
  /// been that large in the picture.
  void render(const Viewpoint& viewpoint, float opacity = 1);

  /// Lays the rendered car over a picture (CV_8UC3) of the viewpoint's size. Throws std::invalid_argument for
  /// any other; allocates nothing.
  void blend_over(cv::Mat& bgr) const;

  /// Premultiplied B, G, R, alpha (CV_8UC4) of the rectangle, which lies within the viewpoint's picture and
  /// may be empty.
  const cv::Mat& premultiplied() const { return picture_; }
  const cv::Rect& rectangle() const { return rectangle_; }

 private:
  struct Face {
    Eigen::Vector3f normal;  // of its plane
    uint32_t part;
  };
  /// The ray from the eye at sample (i, j) of the rectangle, in the vehicle's frame: first + i right + j
  /// down.
  struct Rays {
    Eigen::Vector3f eye, first, right, down;
  };

  cv::Rect extent(const Viewpoint& viewpoint) const;
  Lit lit_triangle(uint32_t triangle, const Eigen::Vector3f& ray, const Eigen::Vector3f& eye) const;
  Lit lit_sample(const Sample& sample, const Eigen::Vector3f& ray, const Eigen::Vector3f& eye) const;
  Lit lit_pixel(int column, int row, const Rays& rays) const;
  bool alike(uint32_t a, uint32_t b) const;
  float shadow(const Eigen::Vector3f& ray, const Eigen::Vector3f& eye) const;

  CarModel model_;
  ContactShadow shadow_;
  Light light_;
  Eigen::AlignedBox3f box_;
  std::vector<Face> faces_;
  uint32_t first_translucent_ = 0;
  Rasteriser rasteriser_;
  cv::Mat memory_;   // as large as the largest picture so far
  cv::Mat picture_;  // the part of it that is in use
  cv::Rect rectangle_;
  cv::Size size_;
};

}  // namespace svchain::car
