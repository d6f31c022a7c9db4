#include "algorithms/car/body_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/car/lighting.h"

namespace svchain::car {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSharpness = 4.6f;  // of the outline from above
constexpr float kEnds = 0.765f;     // beyond this share of the length, ends are bowed and raked
constexpr float kFrontBow = 0.20f, kRearBow = 0.13f;
constexpr float kSetIn = 0.017f;                       // room for what stands out of the ends
constexpr float kFlare = 0.014f, kFlareReach = 0.09f;  // of the wheel arches

float power(float v, float exponent) {
  return std::copysign(std::pow(std::abs(v), exponent), v);
}

/// The outline for a car from -1 to 1.
Eigen::Vector2f outline(float angle) {
  const float c = std::cos(angle), s = std::sin(angle);
  return {std::abs(c) < 1e-6f ? 0 : power(c, 2 / kSharpness), s < 1e-6f ? 0 : power(s, 2 / kSharpness)};
}

Eigen::Vector2f outline_normal(float angle) {
  const Eigen::Vector2f p = outline(angle);
  return Eigen::Vector2f(power(p.x(), kSharpness - 1) * kWidth, power(p.y(), kSharpness - 1) * kLength)
      .normalized();
}

/// How far the skin stays behind the outline, over the height from floor (0) to shoulder (1).
const Curve kSideInset = {{0.0f, 0.070f},  {0.12f, 0.030f}, {0.30f, 0.018f}, {0.55f, 0.012f},
                          {0.70f, 0.014f}, {0.80f, 0.030f}, {0.90f, 0.048f}, {1.0f, 0.062f}};
const Curve kFrontInset = {{0.0f, 0.110f},  {0.12f, 0.030f}, {0.30f, 0.0f}, {0.50f, 0.0f},
                           {0.70f, 0.035f}, {0.85f, 0.085f}, {1.0f, 0.150f}};
const Curve kRearInset = {{0.0f, 0.160f},  {0.15f, 0.060f}, {0.30f, 0.005f}, {0.48f, 0.0f},
                          {0.56f, 0.035f}, {0.75f, 0.060f}, {0.93f, 0.060f}, {1.0f, 0.075f}};
const Curve kDeck = {{-2.40f, 1.02f}, {-2.2f, 1.065f}, {-1.8f, 1.09f}, {-1.0f, 1.06f}, {0.0f, 1.03f},
                     {1.0f, 1.00f},   {1.5f, 0.955f},  {1.9f, 0.895f}, {2.2f, 0.825f}, {2.4f, 0.74f}};

/// 0 along the sides, 1 at the very ends.
float endness(float outline_x) {
  return smoothstep(kEnds, 1, std::abs(outline_x));
}

float flare(float x, float z) {
  float largest = 0;
  for (const float axle : {kFrontAxle, kRearAxle}) {
    const float off = (std::hypot(x - axle, z - kWheelRadius) - kArchRadius) / kFlareReach;
    largest = std::max(largest, std::exp(-off * off));
  }
  return kFlare * largest;
}

Eigen::Vector2f plan_point(float angle, float height) {
  const Eigen::Vector2f unit = outline(angle);
  const float end = endness(unit.x());
  const bool front = unit.x() > 0;
  const float bow = (front ? kFrontBow : kRearBow) * unit.y() * unit.y();
  const float back = end * (bow + (front ? kFrontInset : kRearInset)(height));
  const float y = unit.y() * (kWidth / 2 - kSideInset(height));
  return {unit.x() * kLength / 2 - std::copysign(back + end * kSetIn, unit.x()), y};
}

/// Where the deck begins.
Eigen::Vector2f deck_edge(float angle) {
  return plan_point(angle, 1) - kShoulderRadius * outline_normal(angle);
}

}  // namespace

float Curve::operator()(float x) const {
  if (x <= points_.front().first) return points_.front().second;
  if (x >= points_.back().first) return points_.back().second;
  size_t i = 1;
  while (points_[i].first < x) ++i;
  const auto slope = [&](size_t k) {
    const auto &before = points_[k == 0 ? 0 : k - 1], &after = points_[std::min(k + 1, points_.size() - 1)];
    return (after.second - before.second) / (after.first - before.first);
  };
  const auto& [x0, y0] = points_[i - 1];
  const auto& [x1, y1] = points_[i];
  const float d = x1 - x0, t = (x - x0) / d, u = 1 - t;
  return u * u * (1 + 2 * t) * y0 + t * t * (1 + 2 * u) * y1 + d * t * u * (u * slope(i - 1) - t * slope(i));
}

float side_angle(float x) {
  const float share = std::clamp(2 * x / kLength, -1.0f, 1.0f);
  return std::acos(power(share, kSharpness / 2));
}

float front_angle(float y) {
  return std::asin(std::pow(std::clamp(2 * y / kWidth, 0.0f, 1.0f), kSharpness / 2));
}

float rear_angle(float y) {
  return kPi - front_angle(y);
}

float deck_height(float x, float y) {
  const float share = 2 * y / kWidth;
  return kDeck(x) - 0.075f * share * share;
}

float lower_edge(float x) {
  for (const float axle : {kFrontAxle, kRearAxle}) {
    const float off = std::abs(x - axle);
    if (off <= kArchRadius) return kWheelRadius + std::sqrt(kArchRadius * kArchRadius - off * off);
  }
  return kFloor;
}

float upper_edge(float angle) {
  const Eigen::Vector2f edge = deck_edge(angle);
  return deck_height(edge.x(), edge.y()) - kShoulderRadius;
}

Eigen::Vector3f side_point(float angle, float z, float outwards) {
  const float height = (z - kFloor) / (upper_edge(angle) - kFloor);
  Eigen::Vector2f p = plan_point(angle, height);
  p.y() += flare(p.x(), z) * (1 - endness(outline(angle).x())) * (angle > 0 && angle < kPi);
  p += outwards * outline_normal(angle);
  return {p.x(), p.y(), z};
}

Eigen::Vector3f shoulder_point(float angle, float share) {
  const float turn = share * kPi / 2;
  const Eigen::Vector2f p =
      plan_point(angle, 1) - kShoulderRadius * (1 - std::cos(turn)) * outline_normal(angle);
  return {p.x(), std::max(0.0f, p.y()), upper_edge(angle) + kShoulderRadius * std::sin(turn)};
}

Eigen::Vector3f deck_point(float angle, float share, float upwards) {
  const Eigen::Vector2f edge = deck_edge(angle).cwiseMax(Eigen::Vector2f(-kLength, 0));
  const Eigen::Vector2f middle(std::clamp(edge.x(), -0.40f * kLength, 0.39f * kLength), 0);
  const Eigen::Vector2f p = edge + share * (middle - edge);
  return {p.x(), p.y(), deck_height(p.x(), p.y()) + upwards};
}

}  // namespace svchain::car
