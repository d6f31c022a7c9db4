#include "algorithms/photometric/tone_curves.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::photometric {
namespace {

using synthesis::ToneMapping;

constexpr double kLeastFalloff = 0.01;
constexpr double kFarthestQ2 = 1.2;
constexpr int kFalloffSteps = 24;

const std::array<double, kKnots>& log_knot_levels() {
  static const auto levels = [] {
    std::array<double, kKnots> logs;
    for (int k = 0; k < kKnots; ++k) logs[k] = std::log(kKnotLevels[k]);
    return logs;
  }();
  return levels;
}

struct LevelTable {
  std::array<KnotPlace, 256> place;  // [0] is not used: there is no logarithm

  LevelTable() {
    for (int v = 1; v < 256; ++v) place[v] = place_of(std::log(v));
  }
};

ToneMapping::Curve curve_of(const ToneCurves::Knots& knots) {
  static const LevelTable levels;
  ToneMapping::Curve curve;
  curve[0] = 0;
  for (int v = 1; v < 256; ++v) {
    const double value = v * std::exp(log_gain_at(knots, levels.place[v]));
    curve[v] = std::max(curve[v - 1], static_cast<uint8_t>(std::lround(std::min(255.0, value))));
  }
  return curve;
}

/// Least squares for a1 and a2 at equal steps of q^2.
std::array<int32_t, 2> polynomial_of(const std::array<double, 2>& log_falloff) {
  double q4 = 0, q6 = 0, q8 = 0, right_1 = 0, right_2 = 0, largest = 0;
  for (int i = 1; i <= kFalloffSteps; ++i) {
    const double q2 = kFarthestQ2 * i / kFalloffSteps;
    const double excess = std::expm1(log_falloff[0] * q2 + log_falloff[1] * q2 * q2);
    q4 += q2 * q2;
    q6 += q2 * q2 * q2;
    q8 += q2 * q2 * q2 * q2;
    right_1 += q2 * excess;
    right_2 += q2 * q2 * excess;
    largest = std::max(largest, std::abs(excess));
  }
  if (largest < kLeastFalloff) return {0, 0};
  const double determinant = q4 * q8 - q6 * q6;
  const auto fixed = [](double a) {
    const double limit = synthesis::kLargestFalloff;
    return static_cast<int32_t>(std::lround(std::clamp(a * synthesis::kRadialOne, -limit, limit)));
  };
  return {fixed((right_1 * q8 - right_2 * q6) / determinant),
          fixed((q4 * right_2 - q6 * right_1) / determinant)};
}

}  // namespace

KnotPlace place_of(double log_level) {
  const auto& levels = log_knot_levels();
  int knot = 0;
  while (knot < kKnots - 2 && log_level > levels[knot + 1]) ++knot;
  return {knot, (log_level - levels[knot]) / (levels[knot + 1] - levels[knot])};
}

double slope_at(const ToneCurves::Knots& knots, const KnotPlace& place) {
  const auto& levels = log_knot_levels();
  return (knots[place.knot + 1] - knots[place.knot]) / (levels[place.knot + 1] - levels[place.knot]);
}

ToneMapping tone_mapping(const ToneCurves& curves, size_t cameras) {
  ToneMapping mapping = ToneMapping::identity();
  for (size_t camera = 0; camera < cameras; ++camera) {
    for (size_t c = 0; c < synthesis::kChannels; ++c)
      mapping.curves[camera][c] = curve_of(curves.log_gain[camera][c]);
    mapping.falloff[camera] = polynomial_of(curves.log_falloff[camera]);
  }
  return mapping;
}

}  // namespace svchain::photometric
