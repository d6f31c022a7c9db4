#include "algorithms/synthesis/camera_shares.h"

#include <algorithm>
#include <cmath>

#include "algorithms/synthesis/smoothstep.h"

namespace svchain::synthesis {
namespace {

constexpr double kDegPerRad = 57.295779513082320877;

enum { kFront, kRight, kRear, kLeft };

/// Clockwise order of two neighbours of which `main` has this share.
CameraShares in_order(int main, int other, double share_of_main) {
  if (other == (main + 1) % 4) return {main, other, share_of_main};
  return {other, main, 1 - share_of_main};
}

/// 0 to 1 over the width, about the middle.
double rise(const BlendShape& shape, double past_middle_deg) {
  if (shape.width_deg <= 0) return past_middle_deg > 0 ? 1 : 0;
  const double t = 0.5 + past_middle_deg / shape.width_deg;
  return shape.curve == BlendCurve::kLinear ? std::clamp(t, 0.0, 1.0) : smoothstep(t);
}

}  // namespace

bool is_under_vehicle(const geometry::Vehicle& vehicle, const Eigen::Vector2d& ground) {
  return std::abs(ground.x()) <= vehicle.length_m / 2 && std::abs(ground.y()) <= vehicle.width_m / 2;
}

CameraShares camera_shares(const geometry::Vehicle& vehicle, const BlendShape& shape,
                           const Eigen::Vector2d& ground) {
  const int end = ground.x() >= 0 ? kFront : kRear;
  const int side = ground.y() >= 0 ? kLeft : kRight;
  const double beyond_end = std::abs(ground.x()) - vehicle.length_m / 2;
  const double beyond_side = std::abs(ground.y()) - vehicle.width_m / 2;
  if (beyond_end <= 0) return in_order(side, end, 1);
  if (beyond_side <= 0) return in_order(end, side, 1);

  const double angle_deg = std::atan2(beyond_side, beyond_end) * kDegPerRad;  // 0 straight ahead, 90 abeam
  return in_order(end, side, 1 - rise(shape, angle_deg - 45));
}

int first_weight(const BlendShape& shape, double share_of_first, double first_fade, double second_fade) {
  const double first = first_fade * (share_of_first + (1 - share_of_first) * (1 - second_fade));
  const double either = first_fade + second_fade - first_fade * second_fade;
  const double weight = first / either;
  if (shape.width_deg <= 0) return weight > 0.5 ? 255 : 0;
  return static_cast<int>(std::lround(255 * weight));
}

int shown_weight(const BlendShape& shape, int first_weight) {
  if (shape.curve != BlendCurve::kBinary) return first_weight;
  return first_weight > 127 ? 255 : 0;
}

}  // namespace svchain::synthesis
