#include <cmath>
#include <numbers>

#include "algorithms/car/body_shape.h"
#include "algorithms/car/default_car_parts.h"

namespace svchain::car {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kAround = 24;
constexpr int kSpokes = 5;
constexpr float kOuterFace = 0.918f;  // y of the left wheels' outermost points

/// Radius, and how far inside of the outer face.
struct RingPoint {
  float radius, inside;
};

/// Revolved about the axle: profiles go from the car's side over the tread to the outer face, and inwards.
void add_revolved(SurfaceCollector& surfaces, float axle, const std::vector<RingPoint>& profile,
                  Substance substance, float crease_deg) {
  const SurfaceGrid grid =
      make_grid(kAround + 1, static_cast<int>(profile.size()), [&](int column, int row) -> Eigen::Vector3f {
        const float angle = -2 * kPi * static_cast<float>(column % kAround) / kAround;
        const auto [radius, inside] = profile[row];
        return {axle + radius * std::cos(angle), kOuterFace - inside,
                kWheelRadius + radius * std::sin(angle)};
      });
  surfaces.add_both_sides(
      grid, [&](int, int) { return substance; }, crease_deg);
}

/// One spoke: a bar with slanted flanks from the hub to the rim, the outer end wider apart from its
/// neighbour.
void add_spoke(SurfaceCollector& surfaces, float axle, float hub_angle, float rim_angle) {
  constexpr RingPoint kSection[] = {{-1.0f, 0.07f}, {-0.7f, 0.0f}, {0.7f, 0.0f}, {1.0f, 0.07f}};
  constexpr int kSteps = 4;
  const SurfaceGrid grid = make_grid(4, kSteps, [&](int column, int row) -> Eigen::Vector3f {
    const float out = static_cast<float>(row) / (kSteps - 1);
    const float radius = 0.035f + out * 0.190f, half = 0.021f - 0.004f * out;
    const float angle = hub_angle + out * (rim_angle - hub_angle);
    const Eigen::Vector2f along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    const Eigen::Vector2f p = radius * along + kSection[column].radius * half * across;
    const float inside = 0.030f - 0.014f * out + kSection[column].inside;
    return {axle + p.x(), kOuterFace - inside, kWheelRadius + p.y()};
  });
  surfaces.add_both_sides(
      grid, [](int, int) { return kRim; }, 20);
}

}  // namespace

void add_wheels(SurfaceCollector& surfaces, float axle) {
  const std::vector<RingPoint> tyre = {{0.232f, 0.230f}, {0.250f, 0.214f}, {0.290f, 0.208f}, {0.322f, 0.190f},
                                       {0.335f, 0.165f}, {0.335f, 0.050f}, {0.328f, 0.025f}, {0.312f, 0.008f},
                                       {0.285f, 0.0f},   {0.258f, 0.004f}, {0.240f, 0.012f}};
  const std::vector<RingPoint> rim = {
      {0.243f, 0.012f}, {0.236f, 0.004f}, {0.226f, 0.010f}, {0.222f, 0.035f}, {0.205f, 0.110f}};
  add_revolved(surfaces, axle, tyre, kTyre, 50);
  add_revolved(surfaces, axle, rim, kRim, 50);
  add_revolved(surfaces, axle, {{0.21f, 0.105f}, {0, 0.105f}}, kUnderbody, 40);
  add_revolved(surfaces, axle, {{0.165f, 0.105f}, {0.165f, 0.085f}, {0.07f, 0.085f}}, kDisc, 40);
  add_revolved(surfaces, axle, {{0.062f, 0.09f}, {0.056f, 0.026f}, {0.040f, 0.018f}, {0, 0.016f}}, kRim, 40);
  for (int i = 0; i < kSpokes; ++i) {
    const float angle = kPi / 2 + 2 * kPi * static_cast<float>(i) / kSpokes;
    add_spoke(surfaces, axle, angle - 0.08f, angle - 0.17f);
    add_spoke(surfaces, axle, angle + 0.08f, angle + 0.17f);
  }
}

}  // namespace svchain::car
