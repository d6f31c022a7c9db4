#include "algorithms/geometry/lens_fields.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr json::Range kMaxAngleDeg{1, 180};

}  // namespace

Eigen::Vector2d pair(const json::Value& value, json::Range range) {
  const auto numbers = value.numbers(2, range);
  return {numbers[0], numbers[1]};
}

ordered_json pair(const Eigen::Vector2d& v) {
  return {v.x(), v.y()};
}

double max_angle_rad(const json::Value& lens) {
  const auto given = lens.optional("max_angle_deg");
  return given ? radians(given.number(kMaxAngleDeg, degrees(kUsualMaxAngleRad))) : kUsualMaxAngleRad;
}

double exact_degrees(double angle_rad) {
  const double nearest = degrees(angle_rad);
  for (int digits = 1; digits <= 17; ++digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, nearest);
    if (const double value = std::strtod(text, nullptr); radians(value) == angle_rad) return value;
  }
  for (const double away : {0.0, 360.0}) {
    if (const double value = std::nextafter(nearest, away); radians(value) == angle_rad) return value;
  }
  return nearest;
}

LensPtr within_its_limit(LensPtr made, const json::Value& lens, const std::string& limit) {
  const double widest_deg = degrees(made->max_angle_rad());
  if (!(widest_deg >= kMaxAngleDeg.minimum)) {
    lens.fault("serves no picture: " + limit + " at " + ordered_json(widest_deg).dump() +
               " degrees from the axis");
    return nullptr;
  }
  const auto given = lens.optional("max_angle_deg");
  constexpr double kRoundingDeg = 1e-9;
  if (!given || given.json().get<double>() <= widest_deg + kRoundingDeg) return made;
  char text[96];
  std::snprintf(text, sizeof text, "expected at most %.4f, where %s, got %g", widest_deg, limit.c_str(),
                given.json().get<double>());
  given.fault(text);
  return nullptr;
}

}  // namespace svchain::geometry
