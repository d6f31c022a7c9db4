#pragma once
// How each camera's values are corrected, as the fit knows it: in logarithms, where gains, gammas and a
// lens's falloff are sums. A value v of a channel becomes v exp(s(ln v)), s being linear between six knots
// and going on beyond them; before that it is multiplied by exp(p1 q^2 + p2 q^4), q being the distance from
// the lens's centre in half image widths. A constant s is a gain, a sloping one a gamma. Plain values, pure
// functions.

#include <array>
#include <cstddef>

#include "algorithms/synthesis/tone_mapping.h"

namespace svchain::photometric {

inline constexpr int kKnots = 6;
inline constexpr std::array<double, kKnots> kKnotLevels = {16, 48, 96, 160, 225, 255};  // grey levels

struct ToneCurves {
  using Knots = std::array<double, kKnots>;  // s: ln of the factor

  std::array<std::array<Knots, synthesis::kChannels>, synthesis::kMaxCameras> log_gain = {};
  std::array<std::array<double, 2>, synthesis::kMaxCameras> log_falloff = {};  // p1, p2
};

/// Where a level lies among the knots: s = (1 - t) s[knot] + t s[knot + 1].
struct KnotPlace {
  int knot = 0;
  double t = 0;
};
KnotPlace place_of(double log_level);

inline double log_gain_at(const ToneCurves::Knots& knots, const KnotPlace& place) {
  return knots[place.knot] + place.t * (knots[place.knot + 1] - knots[place.knot]);
}

/// ds / d ln v there.
double slope_at(const ToneCurves::Knots& knots, const KnotPlace& place);

/// The tables that synthesis reads: rounded, within 0..255, never falling; 0 stays 0. Falloff is the
/// polynomial 1 + a1 q^2 + a2 q^4 nearest to it up to q^2 = 1.2, and none where it is below 1 % everywhere.
/// Of the first `cameras`; all others keep their values.
synthesis::ToneMapping tone_mapping(const ToneCurves& curves, size_t cameras);

}  // namespace svchain::photometric
