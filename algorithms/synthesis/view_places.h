#pragma once
// A geometric LUT read the other way round: where the composite shows what a camera has at a place of its
// image. For measuring what a LUT does, whichever way it was made; it needs no lens and no pose. Immutable.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "algorithms/synthesis/geometric_lut.h"

namespace svchain::synthesis {

class ViewPlaces {
 public:
  /// Of one camera; copies what it needs of the LUT.
  ViewPlaces(const GeometricLut& lut, int camera);

  /// Column and row in the composite of a place in the camera's image, both px: where the map about the
  /// nearest pixel that the camera has a part in, taken for affine over a few pixels, puts it. Nothing where
  /// that is more than two pixels off, so that the composite does not have the place from this camera.
  std::optional<Eigen::Vector2d> find(const Eigen::Vector2d& image_px) const;

 private:
  bool has(int column, int row) const;
  const Eigen::Vector2f& at(int column, int row) const { return image_px_[size_t(row) * width_ + column]; }
  Eigen::Vector2i nearest(const Eigen::Vector2d& image_px) const;

  int width_;
  int height_;
  std::vector<Eigen::Vector2f> image_px_;  // for every pixel of the composite; below 0: nothing
};

}  // namespace svchain::synthesis
