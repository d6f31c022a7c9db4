#include "algorithms/bowl/pair_sights.h"

#include <algorithm>
#include <cmath>

namespace svchain::bowl {
namespace {

constexpr double kOffBorderM = 1e-7;

/// The point itself, or, where it lies between two quarters, the nearest that is surely in the pair's.
Eigen::Vector2d within_quarter(int pair, Eigen::Vector2d ground) {
  const double ahead = pair == 0 || pair == 3 ? 1 : -1;
  const double left = pair >= 2 ? 1 : -1;
  if (ground.x() * ahead < kOffBorderM) ground.x() = ahead * kOffBorderM;
  if (ground.y() * left < kOffBorderM) ground.y() = left * kOffBorderM;
  return ground;
}

}  // namespace

int pair_at(const Eigen::Vector2d& ground) {
  if (ground.y() >= 0) return ground.x() >= 0 ? 3 : 2;
  return ground.x() >= 0 ? 0 : 1;
}

PairSights::PairSights(const geometry::Rig& rig, const BowlSurface& surface,
                       const synthesis::BlendShape& shape)
    : rig_(rig), surface_(surface), finder_(rig, shape) {}

PairSight PairSights::at(int pair, const Eigen::Vector2d& ground) const {
  const double height = surface_.height_at(ground);
  const Eigen::Vector2d surely = within_quarter(pair, ground);
  const synthesis::PointSources sources = finder_.find({surely.x(), surely.y(), height});
  PairSight sight;
  if (sources.count == 1) sight.first_weight = sources.camera[0] == pair ? 255 : 0;
  if (sources.count == 2) sight.first_weight = sources.first_weight;
  for (int i = 0; i < 2; ++i) sight.pixel[i] = see((pair + i) % 4, {ground.x(), ground.y(), height});
  return sight;
}

/// As CameraReach, which knows no half pixels beyond the image's outer ones.
std::optional<Eigen::Vector2d> PairSights::see(int camera, const Eigen::Vector3d& point) const {
  auto pixel = rig_.cameras[camera].see(point);
  if (!pixel) return std::nullopt;
  const Eigen::Vector2d last = (rig_.cameras[camera].image_size_px.array() - 1).cast<double>();
  if (!(std::min(pixel->minCoeff(), (last - *pixel).minCoeff()) >= 0)) return std::nullopt;
  return pixel;
}

}  // namespace svchain::bowl
