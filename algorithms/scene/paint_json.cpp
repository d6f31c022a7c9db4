#include "algorithms/scene/paint_json.h"

#include <numbers>

#include "algorithms/scene/shapes.h"

namespace svchain::scene {

namespace {

using json::Value;

const json::Range kPlace{-1e3, 1e3};
const json::Range kLength{1e-4, 1e3};

double length(const Value& item, const char* key) {
  return item.required(key).number(kLength, 1);
}

Pose2 pose(const Value& item) {
  return read_pose(item.required("pose"));
}

int count(const Value& item, const char* key) {
  return static_cast<int>(item.required(key).integer({1, 200}, 1));
}

Outlines read_line(const Value& item) {
  Outline points;
  const Value list = item.required("points_m");
  for (const auto& point : list.items()) {
    const auto xy = point.numbers(2, kPlace);
    points.emplace_back(xy[0], xy[1]);
  }
  if (list.is_array() && points.size() < 2) list.fault("expected at least two points");
  return line(points, length(item, "width_m"));
}

/// What each type of painted thing is read with, and the keys that only it has.
struct Kind {
  const char* type;
  std::vector<std::string> keys;
  Outlines (*read)(const Value& item);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kKinds = {
      {"line", {"points_m", "width_m"}, read_line},
      {"rectangle",
       {"pose", "length_m", "width_m"},
       [](const Value& v) {
         return Outlines{rectangle(pose(v), length(v, "length_m"), length(v, "width_m"))};
       }},
      {"disc",
       {"pose", "radius_m"},
       [](const Value& v) { return Outlines{disc(pose(v), length(v, "radius_m"))}; }},
      {"arrow",
       {"pose", "length_m", "width_m"},
       [](const Value& v) { return arrow(pose(v), length(v, "length_m"), length(v, "width_m")); }},
      {"zebra",
       {"pose", "length_m", "width_m", "bars"},
       [](const Value& v) {
         return zebra(pose(v), length(v, "length_m"), length(v, "width_m"), count(v, "bars"));
       }},
      {"bays",
       {"pose", "count", "length_m", "depth_m", "line_m"},
       [](const Value& v) {
         return bays(pose(v), count(v, "count"), length(v, "length_m"), length(v, "depth_m"),
                     length(v, "line_m"));
       }},
  };
  return kKinds;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const auto& kind : kinds()) names.emplace_back(kind.type);
  return names;
}

}  // namespace

Colour read_colour(const Value& value, Colour usual) {
  if (!value) return usual;
  const auto bgr = value.numbers(3, {0, 255});
  return {static_cast<uint8_t>(bgr[0]), static_cast<uint8_t>(bgr[1]), static_cast<uint8_t>(bgr[2])};
}

Pose2 read_pose(const Value& value) {
  value.only({"x_m", "y_m", "yaw_deg"});
  return {value.required("x_m").number(kPlace), value.required("y_m").number(kPlace),
          value.optional("yaw_deg").number({-360, 360}, 0) * std::numbers::pi / 180};
}

std::vector<Patch> read_paint(const Value& list) {
  std::vector<Patch> patches;
  for (const auto& item : list.items()) {
    const std::string type = item.required("type").choice(kind_names());
    for (const auto& kind : kinds()) {
      if (type != kind.type) continue;
      std::vector<std::string> keys = {"type", "colour_bgr", "opacity"};
      keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
      item.only(keys);
      const Colour colour = read_colour(item.required("colour_bgr"), {});
      const double opacity = item.optional("opacity").number({0, 1}, 1);
      for (auto& outline : kind.read(item)) patches.push_back({std::move(outline), colour, opacity});
    }
  }
  return patches;
}

}  // namespace svchain::scene
