#include "algorithms/scene/panorama.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/scene/hash.h"

namespace svchain::scene {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTexelDeg = 0.2;
constexpr double kLowestDeg = -20;

Colour mixed(Colour a, Colour b, double weight_of_b) {
  const auto channel = [&](uint8_t from, uint8_t to) {
    return static_cast<uint8_t>(std::lround(from + (to - from) * std::clamp(weight_of_b, 0.0, 1.0)));
  };
  return {channel(a.b, b.b), channel(a.g, b.g), channel(a.r, b.r)};
}

/// A row of buildings and trees all around: how high it stands and how far off, by azimuth.
struct Silhouette {
  double height_deg;
  double haze;
};

Silhouette skyline_at(double azimuth_deg, double tallest_deg, uint64_t seed) {
  constexpr double kPlot = 6;  // degrees; 60 plots close the ring
  const double wrapped = azimuth_deg - 360 * std::floor(azimuth_deg / 360);
  const auto plot = static_cast<uint64_t>(wrapped / kPlot);
  const double within = wrapped / kPlot - static_cast<double>(plot);
  const double built = unit(hash(seed, plot, 0u));
  const double haze = 0.15 + 0.5 * unit(hash(seed, plot, 1u));
  if (built > 0.45) {
    const double from = 0.3 * unit(hash(seed, plot, 2u));
    const double to = 1 - 0.3 * unit(hash(seed, plot, 3u));
    if (within > from && within < to) return {tallest_deg * (0.3 + 0.7 * built), haze};
  }
  const double a = wrapped * kDegree;  // a low, wavy line of trees behind
  const double trees = 0.28 + 0.06 * std::sin(7 * a) + 0.05 * std::sin(23 * a + 1) + 0.04 * std::sin(71 * a);
  return {tallest_deg * trees, 0.55};
}

Colour sky_at(const Sky& sky, double elevation_deg) {
  return mixed(sky.horizon, sky.zenith, 1 - std::exp(-elevation_deg / 22));
}

}  // namespace

Panorama make_panorama(const Sky& sky, Colour ground, double margin_rad, uint64_t seed) {
  const double margin_deg = margin_rad / kDegree + 2;
  Panorama panorama;
  panorama.texture = Texture(static_cast<int>((360 + 2 * margin_deg) / kTexelDeg),
                             static_cast<int>((91 - kLowestDeg) / kTexelDeg));
  panorama.radians_per_texel = kTexelDeg * kDegree;
  panorama.first_column = (180 + margin_deg) / kTexelDeg;
  panorama.horizon_row = 90.5 / kTexelDeg;
  for (int y = 0; y < panorama.texture.height; ++y) {
    const double elevation = (panorama.horizon_row - y) * kTexelDeg;
    const Colour above = sky_at(sky, std::max(0.0, elevation));
    const Colour below = mixed(sky.horizon, ground, -elevation / 1.5 + 0.35);
    uint32_t* row = panorama.texture.row(y);
    for (int x = 0; x < panorama.texture.width; ++x) {
      Colour colour = elevation < 0 ? below : above;
      if (elevation >= 0 && elevation < sky.skyline_deg + 1) {
        const Silhouette s = skyline_at((x - panorama.first_column) * kTexelDeg, sky.skyline_deg, seed);
        const double cover = std::clamp((s.height_deg - elevation) / kTexelDeg + 0.5, 0.0, 1.0);
        colour = mixed(above, mixed(sky.skyline, sky.horizon, s.haze), cover);
      }
      row[x] = texel(colour);
    }
  }
  return panorama;
}

}  // namespace svchain::scene
