#include "algorithms/synthesis/view_places.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "algorithms/synthesis/fixed_point.h"
#include "algorithms/synthesis/lut_pixels.h"

namespace svchain::synthesis {
namespace {

constexpr int kAffinePx = 3;  // to each side of a pixel
constexpr double kFarthestPx = 2;
constexpr Eigen::Index kFewestPlaces = 6;

}  // namespace

ViewPlaces::ViewPlaces(const GeometricLut& lut, int camera)
    : width_(lut.header().width),
      height_(lut.header().height),
      image_px_(size_t(width_) * height_, Eigen::Vector2f(-1, -1)) {
  for (const LutBlock& block : lut.blocks())
    for_each_pixel(lut, block, [&](const LutPixel& pixel) {
      const auto read = [&](uint8_t source, uint32_t entry) {
        const LutSource& box = block.sources[source];
        if (box.camera != camera) return;
        const Eigen::Vector2f within(static_cast<float>(entry_x(entry)), static_cast<float>(entry_y(entry)));
        image_px_[size_t(pixel.row) * width_ + pixel.column] =
            Eigen::Vector2f(box.x, box.y) + within / kOnePixel;
      };
      if (pixel.region->tap_count() > 0) read(pixel.region->first, pixel.first);
      if (pixel.region->tap_count() > 1) read(pixel.region->second, pixel.second);
    });
}

bool ViewPlaces::has(int column, int row) const {
  return column >= 0 && column < width_ && row >= 0 && row < height_ && at(column, row).x() >= 0;
}

Eigen::Vector2i ViewPlaces::nearest(const Eigen::Vector2d& image_px) const {
  Eigen::Vector2i best(-1, -1);
  float least = std::numeric_limits<float>::max();
  const Eigen::Vector2f sought = image_px.cast<float>();
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column) {
      if (!has(column, row)) continue;
      const float distance = (at(column, row) - sought).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      best = {column, row};
    }
  return best;
}

std::optional<Eigen::Vector2d> ViewPlaces::find(const Eigen::Vector2d& image_px) const {
  const Eigen::Vector2i start = nearest(image_px);
  if (start.x() < 0) return std::nullopt;
  constexpr Eigen::Index kMost = (2 * kAffinePx + 1) * (2 * kAffinePx + 1);
  Eigen::Matrix<double, kMost, 3> places;
  Eigen::Matrix<double, kMost, 2> images;
  Eigen::Index count = 0;
  for (int dy = -kAffinePx; dy <= kAffinePx; ++dy)
    for (int dx = -kAffinePx; dx <= kAffinePx; ++dx) {
      if (!has(start.x() + dx, start.y() + dy)) continue;
      places.row(count) << dx, dy, 1;
      images.row(count++) = at(start.x() + dx, start.y() + dy).cast<double>();
    }
  if (count < kFewestPlaces) return std::nullopt;
  const auto qr = places.topRows(count).colPivHouseholderQr();
  if (qr.rank() < 3) return std::nullopt;  // all in one line
  const Eigen::Matrix<double, 3, 2> affine = qr.solve(images.topRows(count));
  const Eigen::Matrix2d image_from_view = affine.topRows<2>().transpose();
  if (std::abs(image_from_view.determinant()) < 1e-9) return std::nullopt;
  const Eigen::Vector2d offset = image_from_view.inverse() * (image_px - affine.row(2).transpose());
  if (offset.norm() > kFarthestPx) return std::nullopt;
  return start.cast<double>() + offset;
}

}  // namespace svchain::synthesis
