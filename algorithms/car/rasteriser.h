#pragma once
// Which triangle is seen where: the depth buffers of the car's picture. Two samples a pixel in each
// direction; the nearest opaque triangle and, where it is nearer, the nearest translucent one. One thread at
// a time; allocates only where a picture is larger than all before.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "algorithms/car/car_model.h"
#include "algorithms/car/viewpoint.h"

namespace svchain::car {

inline constexpr int kSamplesPerSide = 2;
inline constexpr uint32_t kNoTriangle = UINT32_MAX;

struct Sample {
  uint32_t opaque = kNoTriangle;
  uint32_t translucent = kNoTriangle;

  bool operator==(const Sample&) const = default;
  bool empty() const { return opaque == kNoTriangle && translucent == kNoTriangle; }
};

class Rasteriser {
 public:
  /// Draws all triangles; those from `first_translucent` on are translucent. What is nearer than `near_m`
  /// along the optical axis is cut off. Nothing outside the rectangle of pixels is kept.
  void draw(const CarModel& model, uint32_t first_translucent, const Viewpoint& viewpoint, double near_m,
            const cv::Rect& rectangle);

  /// Sample (i, j), counted from the rectangle's corner; its place is pixel (rectangle.x - 1/4 + i / 2, ...).
  Sample sample(int i, int j) const {
    const size_t at = static_cast<size_t>(j) * width_ + i;
    const bool pane = translucent_[at].inverse > opaque_[at].inverse;
    return {opaque_[at].triangle, pane ? translucent_[at].triangle : kNoTriangle};
  }

 private:
  struct Point {
    float x, y;     // in samples from the rectangle's first
    float inverse;  // of the depth
  };
  /// The nearest triangle at each sample.
  struct Layer {
    float inverse = 0;
    uint32_t triangle = kNoTriangle;
  };
  void draw(uint32_t triangle, std::vector<Layer>& layer, const Point& a, const Point& b, const Point& c);
  void draw_clipped(uint32_t triangle, std::vector<Layer>& layer, const std::array<Eigen::Vector3f, 3>& seen);
  Point projected(const Eigen::Vector3f& seen) const;

  int width_ = 0, height_ = 0;  // in samples
  float near_ = 0, focal_ = 0;
  Eigen::Vector2f centre_ = {0, 0};
  std::vector<Layer> opaque_, translucent_;
  std::vector<Eigen::Vector3f> seen_;
  std::vector<Point> points_;
};

}  // namespace svchain::car
