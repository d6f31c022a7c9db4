#include <cmath>
#include <numbers>

#include "algorithms/car/body_shape.h"
#include "algorithms/car/default_car_parts.h"

namespace svchain::car {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSharpness = 5.5f;

/// A horizontal outline, ends bowed.
struct Ring {
  float front, rear, half_width, front_bow, rear_bow;
};
constexpr Ring kBelt = {1.16f, -1.92f, 0.815f, 0.26f, 0.16f};
constexpr Ring kEaves = {0.26f, -1.16f, 0.615f, 0.12f, 0.10f};
constexpr float kEavesHeight = 1.395f, kRoofRise = 0.065f;

/// One column of the cabin's skin: its place on the outline, and what the cell after it is.
enum class Panel { kWindscreen, kPillar, kDoorPillar, kSideWindow, kRearWindow };
struct Column {
  Eigen::Vector2f place;  // on the outline from -1 to 1
  Panel panel;
};

Eigen::Vector2f place_at_x(float x) {
  return {x, std::pow(1 - std::pow(std::abs(x), kSharpness), 1 / kSharpness)};
}
Eigen::Vector2f place_at_y(float y, float end) {
  return {end * std::pow(1 - std::pow(y, kSharpness), 1 / kSharpness), y};
}

std::vector<Column> columns() {
  std::vector<Column> all;
  for (const float y : {0.0f, 0.18f, 0.36f, 0.54f, 0.70f, 0.82f})
    all.push_back({place_at_y(y, 1), Panel::kWindscreen});
  all.push_back({place_at_y(0.885f, 1), Panel::kPillar});
  all.push_back({place_at_x(0.865f), Panel::kPillar});
  for (const float x : {0.80f, 0.64f, 0.46f, 0.28f}) all.push_back({place_at_x(x), Panel::kSideWindow});
  all.push_back({place_at_x(0.13f), Panel::kDoorPillar});
  for (const float x : {0.07f, -0.14f, -0.34f, -0.52f}) all.push_back({place_at_x(x), Panel::kSideWindow});
  for (const float x : {-0.66f, -0.76f, -0.85f}) all.push_back({place_at_x(x), Panel::kPillar});
  all.push_back({place_at_y(0.92f, -1), Panel::kPillar});
  for (const float y : {0.86f, 0.74f, 0.56f, 0.38f, 0.2f, 0.0f})
    all.push_back({place_at_y(y, -1), Panel::kRearWindow});
  return all;
}

Eigen::Vector2f on(const Ring& ring, const Eigen::Vector2f& place) {
  const float bow = (place.x() > 0 ? ring.front_bow : -ring.rear_bow) * place.y() * place.y();
  const float middle = (ring.front + ring.rear) / 2, half = (ring.front - ring.rear) / 2;
  return {middle + half * place.x() - bow * std::abs(place.x()), ring.half_width * place.y()};
}

/// Between belt (0) and eaves (1), a little convex.
Eigen::Vector3f wall_point(const Eigen::Vector2f& place, float up) {
  const Eigen::Vector2f low = on(kBelt, place), high = on(kEaves, place);
  const float foot = deck_height(low.x(), low.y()) - 0.02f;
  const float eaves = kEavesHeight - 0.03f * std::max(0.0f, -place.x());
  const float bulge = 4 * up * (1 - up);
  const Eigen::Vector2f p = low + up * (high - low) + 0.022f * bulge * Eigen::Vector2f(place.x(), place.y());
  return {p.x(), p.y(), foot + up * (eaves - foot) + 0.030f * bulge * std::abs(place.x())};
}

Eigen::Vector3f roof_point(const Eigen::Vector2f& place, float inwards) {
  const Eigen::Vector3f edge = wall_point(place, 1);
  const float middle = std::clamp(edge.x(), kEaves.rear + 0.55f, kEaves.front - 0.55f);
  const float rise = kRoofRise * (1 - std::pow(1 - inwards, 2.4f));
  const float ridge = kEavesHeight - 0.03f * std::max(0.0f, (kEaves.front + kEaves.rear - 2 * middle) /
                                                                (kEaves.front - kEaves.rear));
  return {edge.x() + inwards * (middle - edge.x()), (1 - inwards) * edge.y(),
          edge.z() + inwards * (ridge - edge.z()) + rise};
}

constexpr float kUp[] = {0, 0.07f, 0.30f, 0.55f, 0.78f, 0.90f, 1};
constexpr float kInwards[] = {0.06f, 0.14f, 0.26f, 0.42f, 0.62f, 0.82f, 1};
constexpr int kWallRows = std::size(kUp), kRoofRows = std::size(kInwards);

Substance substance(Panel panel, int row) {
  if (row == 0) return kTrim;
  if (row >= kWallRows - 2) return kPaint;
  switch (panel) {
    case Panel::kWindscreen:
    case Panel::kSideWindow:
    case Panel::kRearWindow:
      return kGlass;
    case Panel::kDoorPillar:
      return kTrim;
    case Panel::kPillar:
      break;
  }
  return kPaint;
}

void add_skin(SurfaceCollector& surfaces) {
  const std::vector<Column> all = columns();
  const SurfaceGrid grid = make_grid(
      static_cast<int>(all.size()), kWallRows + kRoofRows, [&](int column, int row) -> Eigen::Vector3f {
        const Eigen::Vector2f& place = all[column].place;
        return row < kWallRows ? wall_point(place, kUp[row]) : roof_point(place, kInwards[row - kWallRows]);
      });
  surfaces.add_both_sides(
      grid, [&](int column, int row) { return substance(all[column].panel, row); }, 50);
  // What the cabin stands on, seen through the windows.
  constexpr int kRows = 3;
  surfaces.add_both_sides(make_grid(static_cast<int>(all.size()), kRows,
                                    [&](int column, int row) -> Eigen::Vector3f {
                                      const float share = static_cast<float>(row) / (kRows - 1);
                                      const Eigen::Vector3f edge = wall_point(all[column].place, 0);
                                      const float middle = std::clamp(edge.x(), -1.2f, 0.5f);
                                      const float x = edge.x() + share * (middle - edge.x());
                                      const float y = (1 - share) * edge.y();
                                      return {x, y, deck_height(x, y) + 0.012f};
                                    }),
                          [](int, int) { return kInterior; });
}

void add_inside(SurfaceCollector& surfaces) {
  const auto box = [&](Eigen::Vector3f centre, Eigen::Vector3f half) {
    surfaces.add_both_sides(rounded_box(centre, half, 3.5f), [](int, int) { return kInterior; });
  };
  for (const float x : {-0.22f, -1.02f}) {
    box({x, 0.36f, 1.08f}, {0.07f, 0.23f, 0.13f});
    box({x - 0.03f, 0.36f, 1.24f}, {0.045f, 0.12f, 0.065f});
  }
}

void add_antenna(SurfaceCollector& surfaces) {
  surfaces.add(rounded_box({-0.90f, 0, 1.43f}, {0.085f, 0.020f, 0.045f}, 2.2f),
               [](int, int) { return kPaint; });
}

void add_mirrors(SurfaceCollector& surfaces) {
  surfaces.add_both_sides(rounded_box({0.74f, 0.985f, 1.045f}, {0.075f, 0.115f, 0.070f}, 3.0f),
                          [](int, int) { return kPaint; });
  surfaces.add_both_sides(rounded_box({0.76f, 0.87f, 1.00f}, {0.035f, 0.08f, 0.02f}, 3.0f),
                          [](int, int) { return kTrim; });
  surfaces.add_both_sides(rounded_box({0.667f, 0.985f, 1.045f}, {0.006f, 0.095f, 0.055f}, 4.0f),
                          [](int, int) { return kChrome; });
}

}  // namespace

void add_cabin(SurfaceCollector& surfaces) {
  add_skin(surfaces);
  add_inside(surfaces);
  add_antenna(surfaces);
  add_mirrors(surfaces);
}

}  // namespace svchain::car
