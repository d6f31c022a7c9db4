#pragma once
// A row of pixels, from the triangles at their samples to the mean light of each. Samples of a pixel that see
// much the same are lit once. Owns its memory, which grows with the longest row; one thread at a time.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/car/rasteriser.h"
#include "algorithms/car/row_lighting.h"

namespace svchain::car {

/// Of a triangle.
struct Plane {
  Eigen::Vector3f normal;  // unit
  uint32_t part;           // of the model
};

class SampleRow {
 public:
  /// Row `row` of the rectangle, which begins at row `first` of the band's samples. The result is R, G, B,
  /// premultiplied and linear, and alpha of each pixel, with room for whole vectors.
  const float* mean_light(const SampleBand& samples, int first, int row, int columns, const Scenery& scenery,
                          std::span<const Plane> planes);
  /// For as many pixels, with room for whole vectors.
  uint32_t* bytes() { return bytes_.data(); }

 private:
  using Colour = Eigen::Array4f;
  static constexpr int32_t kNothing = -1;

  /// Samples of a pixel that are lit together.
  struct Group {
    int32_t column;
    float share;                  // of the pixel
    int32_t opaque, translucent;  // places among what is lit
  };

  void reserve(int columns);
  void gather(const SampleBand& samples, int first, int row, int columns, std::span<const Plane> planes);
  void split(std::array<Sample, 4>& samples, int column, int row, std::span<const Plane> planes);
  void add(const Sample& sample, int column, int row, int k, int count);

  std::vector<int32_t> facets_;  // what is lit
  std::vector<float> columns_, rows_;
  std::vector<Colour> colours_;
  size_t lit_count_ = 0;
  std::vector<Group> groups_;
  size_t group_count_ = 0;
  std::vector<Colour> means_;
  std::vector<uint32_t> bytes_;
};

}  // namespace svchain::car
