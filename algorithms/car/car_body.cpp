#include <algorithm>
#include <numbers>

#include "algorithms/car/body_shape.h"
#include "algorithms/car/default_car_parts.h"

namespace svchain::car {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kUnderRows = 4, kSideRows = 10, kShoulderRows = 3, kDeckRows = 5;
constexpr float kWellDepth = 0.30f;  // of the wheel wells

/// Angles around the body, close together where it turns and at the wheel arches.
std::vector<float> columns() {
  std::vector<float> angles;
  const auto at_end = [&](float (*angle)(float)) {
    for (const float y : {0.0f, 0.16f, 0.32f, 0.46f, 0.58f, 0.67f, 0.74f, 0.80f, 0.845f, 0.88f})
      angles.push_back(angle(y));
  };
  at_end(front_angle);
  at_end(rear_angle);
  for (const float x : {2.14f, 2.06f, 1.97f, 1.88f, 0.80f, 0.55f, 0.2f, -0.2f, -0.55f, -0.80f, -1.86f, -1.96f,
                        -2.06f, -2.14f})
    angles.push_back(side_angle(x));
  for (const float axle : {kFrontAxle, kRearAxle}) {
    constexpr int kArchColumns = 11;
    for (int i = 0; i <= kArchColumns; ++i)
      angles.push_back(
          side_angle(axle + 0.9999f * kArchRadius * std::cos(kPi * static_cast<float>(i) / kArchColumns)));
    for (const float x : {-1.012f, 1.012f}) angles.push_back(side_angle(axle + x * kArchRadius));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// From the floor's middle outwards, up the side, over the shoulder and back to the middle.
Eigen::Vector3f skin_point(float angle, int row) {
  const float x = side_point(angle, kFloor).x(), low = lower_edge(x);
  const Eigen::Vector3f edge = side_point(angle, low);
  if (row < kUnderRows - 1) {
    const float inner = std::max(0.0f, std::min(edge.y(), kWidth / 2 - kWellDepth));
    if (row == 0) return {edge.x(), 0, kFloor};
    return {edge.x(), inner, row == 1 ? kFloor : low};
  }
  const int up = row - (kUnderRows - 1);
  if (up <= kSideRows)
    return side_point(angle, low + (upper_edge(angle) - low) * static_cast<float>(up) / kSideRows);
  const int over = up - kSideRows;
  if (over <= kShoulderRows) return shoulder_point(angle, static_cast<float>(over) / kShoulderRows);
  return deck_point(angle, static_cast<float>(over - kShoulderRows) / kDeckRows);
}

void add_skin(SurfaceCollector& surfaces) {
  const std::vector<float> angles = columns();
  constexpr int kRows = kUnderRows + kSideRows + kShoulderRows + kDeckRows;
  const SurfaceGrid grid = make_grid(static_cast<int>(angles.size()), kRows,
                                     [&](int column, int row) { return skin_point(angles[column], row); });
  surfaces.add_both_sides(
      grid, [](int, int row) { return row < kUnderRows - 1 ? kUnderbody : kPaint; }, 32);
}

/// Something set into the side between two angles and two heights that change linearly from one to the other.
struct Inset {
  float first_angle, last_angle;
  float first_low, first_high, last_low, last_high;
  Substance substance;
  float outwards = 0.006f;
};

void add_inset(SurfaceCollector& surfaces, const Inset& inset) {
  constexpr int kColumns = 12, kRows = 4;
  const SurfaceGrid grid = make_grid(kColumns, kRows, [&](int column, int row) {
    const float along = static_cast<float>(column) / (kColumns - 1),
                up = static_cast<float>(row) / (kRows - 1);
    const float low = inset.first_low + along * (inset.last_low - inset.first_low);
    const float high = inset.first_high + along * (inset.last_high - inset.first_high);
    const float angle = inset.first_angle + along * (inset.last_angle - inset.first_angle);
    const bool rim = column == 0 || column == kColumns - 1 || row == 0 || row == kRows - 1;
    Eigen::Vector3f p = side_point(angle, low + up * (high - low), rim ? 0.004f : inset.outwards);
    if (column == 0 && inset.first_angle == 0) p = side_point(angle, p.z(), inset.outwards);
    if (column == kColumns - 1 && inset.last_angle == kPi) p = side_point(angle, p.z(), inset.outwards);
    if (angle == 0 || angle == kPi) p.y() = 0;
    return p;
  });
  surfaces.add_both_sides(
      grid, [&](int, int) { return inset.substance; }, 60);
}

void add_lights(SurfaceCollector& surfaces) {
  add_inset(surfaces, {front_angle(0.47f), side_angle(1.90f), 0.625f, 0.700f, 0.665f, 0.795f, kTrim, 0.008f});
  add_inset(surfaces,
            {front_angle(0.50f), side_angle(1.95f), 0.680f, 0.693f, 0.755f, 0.775f, kLightFront, 0.014f});
  add_inset(surfaces,
            {front_angle(0.55f), front_angle(0.68f), 0.635f, 0.675f, 0.640f, 0.692f, kLightFront, 0.014f});
  add_inset(surfaces,
            {front_angle(0.72f), front_angle(0.83f), 0.645f, 0.698f, 0.655f, 0.712f, kLightFront, 0.014f});
  add_inset(surfaces,
            {side_angle(-1.98f), rear_angle(0.36f), 0.835f, 0.935f, 0.800f, 0.905f, kLightRear, 0.012f});
  add_inset(surfaces, {rear_angle(0.36f), kPi, 0.850f, 0.875f, 0.850f, 0.875f, kLightRear, 0.008f});
}

void add_ends(SurfaceCollector& surfaces) {
  add_inset(surfaces, {0, front_angle(0.56f), 0.47f, 0.625f, 0.50f, 0.60f, kTrim});
  add_inset(surfaces, {0, front_angle(0.50f), 0.585f, 0.597f, 0.575f, 0.587f, kChrome, 0.012f});
  add_inset(surfaces, {0, front_angle(0.60f), 0.225f, 0.345f, 0.225f, 0.320f, kTrim});
  add_inset(surfaces, {front_angle(0.68f), front_angle(0.84f), 0.25f, 0.36f, 0.27f, 0.44f, kTrim});
  add_inset(surfaces, {0, front_angle(0.26f), 0.365f, 0.460f, 0.365f, 0.460f, kPlate, 0.016f});
  add_inset(surfaces, {rear_angle(0.74f), kPi, 0.22f, 0.32f, 0.22f, 0.40f, kTrim});
  add_inset(surfaces, {rear_angle(0.26f), kPi, 0.655f, 0.765f, 0.655f, 0.765f, kPlate, 0.012f});
}

void add_doors(SurfaceCollector& surfaces) {
  const auto line = [&](float x, float lean, float low, float high) {
    constexpr float kHalf = 0.008f;
    constexpr int kRows = 14;
    surfaces.add_both_sides(make_grid(2, kRows,
                                      [&](int column, int row) {
                                        const float up = static_cast<float>(row) / (kRows - 1);
                                        const float at = x + lean * up + (column == 0 ? kHalf : -kHalf);
                                        return side_point(side_angle(at), low + up * (high - low), 0.003f);
                                      }),
                            [](int, int) { return kTrim; });
  };
  line(0.92f, 0.08f, 0.27f, 0.88f);
  line(-0.10f, -0.02f, 0.27f, 0.91f);
  line(-0.93f, -0.22f, 0.72f, 0.92f);
  for (const float x : {0.14f, -0.86f})
    surfaces.add_both_sides(rounded_box({x, 0.905f, 0.835f}, {0.10f, 0.030f, 0.016f}, 3),
                            [](int, int) { return kPaint; });
  const float front = side_angle(kFrontAxle - 1.03f * kArchRadius),
              rear = side_angle(kRearAxle + 1.03f * kArchRadius);
  add_inset(surfaces, {front, rear, kFloor, 0.265f, kFloor, 0.265f, kTrim, 0.012f});
}

/// The gap around the bonnet, and that of the boot.
void add_lids(SurfaceCollector& surfaces) {
  const auto gap = [&](std::initializer_list<Eigen::Vector2f> path) {
    for (auto p = path.begin(); p + 1 != path.end(); ++p) {
      constexpr int kSteps = 10;
      const Eigen::Vector2f a = *p, b = *(p + 1);
      const Eigen::Vector2f across = 0.006f * Eigen::Vector2f(a.y() - b.y(), b.x() - a.x()).normalized();
      surfaces.add_both_sides(make_grid(2, kSteps,
                                        [&](int column, int row) -> Eigen::Vector3f {
                                          const float t = static_cast<float>(row) / (kSteps - 1);
                                          const Eigen::Vector2f q =
                                              a + t * (b - a) + (column == 0 ? 1.0f : -1.0f) * across;
                                          return {q.x(), q.y(), deck_height(q.x(), q.y()) + 0.003f};
                                        }),
                              [](int, int) { return kTrim; });
    }
  };
  gap({{1.00f, 0.735f}, {1.70f, 0.70f}, {2.02f, 0.62f}});
  gap({{-1.80f, 0.66f}, {-2.10f, 0.66f}});
}

}  // namespace

void add_body(SurfaceCollector& surfaces) {
  add_skin(surfaces);
  add_lights(surfaces);
  add_ends(surfaces);
  add_doors(surfaces);
  add_lids(surfaces);
}

}  // namespace svchain::car
