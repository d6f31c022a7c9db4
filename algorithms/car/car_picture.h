#pragma once
// The car as a viewpoint shows it, kept so that a viewpoint that stands still costs one alpha blend a frame.
// Edges have four samples a pixel; lighting.h says how surfaces look and contact_shadow.h how dark the ground
// under them is. Owns the model and the picture.
//
// The steps are begin(), by one thread, then draw() of all parts, by any threads at the same time; render()
// does both in one. `blend_over` and the readers in any thread between two renderings. They allocate only
// where the car needs more than in all pictures before.

#include <array>
#include <opencv2/core/mat.hpp>

#include "algorithms/car/car_model.h"
#include "algorithms/car/contact_shadow.h"
#include "algorithms/car/lighting.h"
#include "algorithms/car/rasteriser.h"
#include "algorithms/car/row_lighting.h"
#include "algorithms/car/sample_row.h"
#include "algorithms/car/viewpoint.h"

namespace svchain::car {

class CarPicture {
 public:
  static constexpr int kMostParts = 16;

  /// The model stands on the ground of the vehicle's frame; the shadow is the vehicle's rectangle's.
  CarPicture(CarModel model, const geometry::Vehicle& vehicle, const Light& light = bright_day());

  /// Prepares to draw the car, `opacity` (0..1) times as dense as it is, shadow included. Whatever is out of
  /// sight or behind the eye is left out; an eye inside the car sees it from there.
  void begin(const Viewpoint& viewpoint, float opacity = 1);
  /// 1 to kMostParts parts.
  void draw(int part, int parts);
  /// All of it, in one part.
  void render(const Viewpoint& viewpoint, float opacity = 1);

  /// Lays the rendered car over a picture (CV_8UC3) of the viewpoint's size. Throws std::invalid_argument for
  /// any other; allocates nothing.
  void blend_over(cv::Mat& bgr) const;

  /// Premultiplied B, G, R, alpha (CV_8UC4) of the rectangle, which lies within the viewpoint's picture and
  /// may be empty.
  const cv::Mat& premultiplied() const { return picture_; }
  const cv::Rect& rectangle() const { return rectangle_; }

 private:
  /// What a part works in.
  struct Desk {
    SampleBand samples;
    SampleRow row;
  };

  cv::Rect extent(const Viewpoint& viewpoint, const Rasteriser::Bounds& model) const;
  void draw_band(int band, Desk& desk);

  CarModel model_;
  ContactShadow shadow_;
  Eigen::AlignedBox3f box_;
  std::vector<Plane> planes_;
  std::vector<Substance> substances_;  // of the parts
  uint32_t first_translucent_ = 0;
  Rasteriser rasteriser_;
  std::vector<Facet> facets_;
  Scenery scenery_;
  float opacity_ = 1;
  std::array<Desk, kMostParts> desks_;
  cv::Mat memory_;   // as large as the largest picture so far
  cv::Mat picture_;  // the part of it that is in use
  cv::Rect rectangle_;
  cv::Size size_;
};

}  // namespace svchain::car
