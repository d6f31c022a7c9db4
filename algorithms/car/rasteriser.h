#pragma once
// Which triangle is seen where: the depth buffers of the car's picture, made in bands of rows that stay in a
// processor's cache. Two samples a pixel in each direction; the nearest opaque triangle and, where it is
// nearer, the nearest translucent one. project() and sort() by one thread, then draw() of bands by any
// threads at the same time, each into a SampleBand of its own. Allocates only where a picture needs more than
// all before.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <span>
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

/// The samples of a few rows of the picture.
class SampleBand {
 public:
  /// All of them empty.
  void clear(int columns, int rows);
  /// Counted from the band's first.
  Sample sample(int i, int j) const {
    const size_t at = static_cast<size_t>(j) * columns_ + i;
    return {opaque_[at], translucent_[at]};
  }

 private:
  friend class Rasteriser;
  int columns_ = 0;
  std::vector<float> inverse_;  // of the depth of what is nearest so far
  std::vector<uint32_t> opaque_, translucent_;
};

class Rasteriser {
 public:
  static constexpr int kBandRows = 16;  // of pixels

  /// Where a model is in the picture's plane.
  struct Bounds {
    Eigen::AlignedBox2d box_px;  // of what is before the near plane
    bool behind = false;         // something is not
  };

  /// What is nearer than `near_m` along the optical axis will be cut off.
  const Bounds& project(const CarModel& model, const Viewpoint& viewpoint, double near_m);
  /// Finds the bands of each triangle. Those from `first_translucent` on are translucent. Nothing outside the
  /// rectangle of pixels is kept.
  void sort(const CarModel& model, uint32_t first_translucent, const cv::Rect& rectangle);
  /// Of kBandRows each, but for the last.
  int band_count() const { return static_cast<int>(starts_.size()) - 1; }
  /// Whether a triangle is in any band.
  bool may_show(uint32_t triangle) const { return bands_[triangle].first <= bands_[triangle].last; }
  /// Triangles that may have samples in the band, in the model's order.
  std::span<const uint32_t> triangles(int band) const {
    return std::span(sorted_).subspan(starts_[band], starts_[band + 1] - starts_[band]);
  }
  /// Sample (i, j) of a band is at pixel (rectangle.x - 1/4 + i / 2, first row - 1/4 + j / 2).
  void draw(const CarModel& model, int band, SampleBand& samples) const;

 private:
  struct Point {
    float x, y;     // in samples from the picture's first
    float inverse;  // of the depth
  };
  struct Bands {
    int16_t first = 0, last = -1;
  };
  struct Target;
  Bands bands_of(const uint32_t* corners) const;
  void draw_clipped(uint32_t triangle, const Target& target, const uint32_t* corners) const;
  Point projected(const Eigen::Vector3f& seen) const;

  float near_ = 0, focal_ = 0;
  Eigen::Vector2f centre_ = {0, 0};
  Bounds bounds_;
  cv::Rect samples_;  // of the picture that are kept
  uint32_t first_translucent_ = 0;
  std::vector<Eigen::Vector3f> seen_;
  std::vector<Point> points_;
  std::vector<Bands> bands_;            // of each triangle
  std::vector<uint32_t> starts_ = {0};  // of each band in:
  std::vector<uint32_t> sorted_;
};

}  // namespace svchain::car
