#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "algorithms/calibration/charts.h"
#include "algorithms/geometry/angles.h"
#include "algorithms/json/value.h"

namespace svchain::calibration {

namespace {

using json::Value;
using nlohmann::ordered_json;

// Bounds as in configs/schemas/charts.schema.json.
constexpr json::Range kPlaceM{-100, 100, "m"};
constexpr json::Range kYawDeg{-360, 360, "degrees"};
constexpr json::Range kSideM{0, 10, "m"};
constexpr json::Range kSquares{2, 100};
constexpr json::Range kTagId{0, 586};
constexpr double kSamePlace = 1e-3;  // of a side

double read_side(const Value& side) {
  const double metres = side.number(kSideM);
  if (side.is_number() && side.json() == 0) side.fault("expected more than 0 m");
  return metres;
}

std::optional<geometry::Pose2> read_pose(const Value& pose) {
  if (!pose) return std::nullopt;
  pose.only({"x_m", "y_m", "yaw_deg"});
  return geometry::Pose2{pose.required("x_m").number(kPlaceM), pose.required("y_m").number(kPlaceM),
                         geometry::radians(pose.required("yaw_deg").number(kYawDeg))};
}

/// How two squares of one side lie to each other.
enum class Contact { kNone, kCorner, kEdge, kOverlap };

Contact contact(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double side_m) {
  const Eigen::Vector2d apart = (a - b).cwiseAbs();
  const double slack = kSamePlace * side_m;
  if (side_m == 0) return Contact::kNone;  // it is at fault itself
  if (apart.maxCoeff() > side_m + slack) return Contact::kNone;
  if (apart.minCoeff() >= side_m - slack) return Contact::kCorner;
  return apart.maxCoeff() < side_m - slack ? Contact::kOverlap : Contact::kEdge;
}

/// What the square at the end of the list does to those before it, if that cannot be.
std::string clash(const std::vector<Eigen::Vector2d>& centres, double side_m, const std::string& what,
                  bool corners_may_touch) {
  for (size_t i = 0; i + 1 < centres.size(); ++i) {
    const std::string other = what + " " + std::to_string(i);
    switch (contact(centres[i], centres.back(), side_m)) {
      case Contact::kNone:
        break;
      case Contact::kOverlap:
        return "overlaps " + other;
      case Contact::kEdge:
        return "shares an edge with " + other + ", where no corner can be seen";
      case Contact::kCorner:
        if (!corners_may_touch) return "touches " + other + ", expected white all around";
    }
  }
  return {};
}

void read_checkerboard(const Value& item, Chart& chart) {
  const auto squares = item.required("squares").items(2);
  for (size_t i = 0; i < squares.size(); ++i)
    chart.squares[i] = static_cast<int>(squares[i].integer(kSquares, 2));
  chart.side_m = read_side(item.required("square_m"));
}

void read_squares(const Value& item, Chart& chart) {
  chart.side_m = read_side(item.required("side_m"));
  const Value list = item.required("centres_m");
  for (const auto& centre : list.items()) {
    const size_t before = centre.fault_count();
    const auto xy = centre.numbers(2, kPlaceM);
    if (centre.fault_count() > before) continue;
    chart.centres_m.emplace_back(xy[0], xy[1]);
    const std::string why = clash(chart.centres_m, chart.side_m, "square", true);
    if (!why.empty()) centre.fault(why);
  }
  if (list.is_array() && list.items().empty()) list.fault("expected at least one square");
}

void read_tags(const Value& item, Chart& chart, std::set<int>& ids) {
  chart.side_m = read_side(item.required("tag_m"));
  const Value list = item.required("tags");
  std::vector<Eigen::Vector2d> centres;
  for (const auto& one : list.items()) {
    one.only({"id", "x_m", "y_m"});
    const size_t before = one.fault_count();
    Tag tag;
    const Value id = one.required("id");
    tag.id = static_cast<int>(id.integer(kTagId, -1));
    tag.place_m = {one.required("x_m").number(kPlaceM), one.required("y_m").number(kPlaceM)};
    if (tag.id >= 0 && !ids.insert(tag.id).second)
      id.fault("tag " + std::to_string(tag.id) + " is in this file already, expected every id once");
    if (one.fault_count() > before) continue;
    chart.tags.push_back(tag);
    centres.push_back(tag.place_m);
    const std::string why = clash(centres, chart.side_m, "tag", false);
    if (!why.empty()) one.fault(why);
  }
  if (list.is_array() && list.items().empty()) list.fault("expected at least one tag");
}

Chart read_chart(const Value& item, std::set<int>& tag_ids) {
  Chart chart;
  chart.name = item.required("name").string();
  if (const Value name = item.optional("name"); name.is_string() && chart.name.empty())
    name.fault("expected a name");
  chart.vehicle_from_chart = read_pose(item.optional("pose"));
  const std::string type = item.required("type").choice({"checkerboard", "squares", "apriltag_36h11"});
  if (type == "checkerboard") {
    item.only({"name", "type", "squares", "square_m", "pose"});
    chart.type = ChartType::kCheckerboard;
    read_checkerboard(item, chart);
  } else if (type == "squares") {
    item.only({"name", "type", "side_m", "centres_m", "pose"});
    chart.type = ChartType::kSquares;
    read_squares(item, chart);
  } else if (type == "apriltag_36h11") {
    item.only({"name", "type", "tag_m", "tags", "pose"});
    chart.type = ChartType::kAprilTag36h11;
    read_tags(item, chart, tag_ids);
  }
  return chart;
}

/// The shortest number of degrees that is this angle: what was written as 33.3 is 33.3 again.
double shortest_degrees(double angle_rad) {
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, geometry::degrees(angle_rad));
    const double degrees = std::strtod(text, nullptr);
    if (geometry::radians(degrees) == angle_rad) return degrees;
  }
  return geometry::degrees(angle_rad);
}

ordered_json chart_json(const Chart& chart) {
  ordered_json item = {{"name", chart.name}};
  switch (chart.type) {
    case ChartType::kCheckerboard:
      item.update({{"type", "checkerboard"}, {"squares", chart.squares}, {"square_m", chart.side_m}});
      break;
    case ChartType::kSquares: {
      item.update({{"type", "squares"}, {"side_m", chart.side_m}, {"centres_m", ordered_json::array()}});
      for (const auto& centre : chart.centres_m) item["centres_m"].push_back({centre.x(), centre.y()});
      break;
    }
    case ChartType::kAprilTag36h11: {
      item.update({{"type", "apriltag_36h11"}, {"tag_m", chart.side_m}, {"tags", ordered_json::array()}});
      for (const auto& tag : chart.tags)
        item["tags"].push_back({{"id", tag.id}, {"x_m", tag.place_m.x()}, {"y_m", tag.place_m.y()}});
      break;
    }
  }
  if (const auto& pose = chart.vehicle_from_chart)
    item["pose"] = {{"x_m", pose->x_m}, {"y_m", pose->y_m}, {"yaw_deg", shortest_degrees(pose->yaw_rad)}};
  return item;
}

}  // namespace

Result<std::vector<Chart>> parse_charts(const std::string& text, const std::string& file) {
  auto document = json::Document::parse(text, file);
  if (!document) return tl::unexpected(std::move(document.error()));
  Faults faults;
  const Value root(*document, faults);
  root.only({"charts"});
  const Value list = root.required("charts");
  std::vector<Chart> charts;
  std::set<std::string> names;
  std::set<int> tag_ids;
  for (const auto& item : list.items()) {
    charts.push_back(read_chart(item, tag_ids));
    const std::string& name = charts.back().name;
    if (!name.empty() && !names.insert(name).second)
      item.optional("name").fault("\"" + name + "\" is another chart's name already");
  }
  if (list.is_array() && list.items().empty()) list.fault("expected at least one chart");
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return charts;
}

Result<std::vector<Chart>> read_charts(const std::filesystem::path& path) {
  auto text = json::read_text(path);
  if (!text) return tl::unexpected(std::move(text.error()));
  return parse_charts(*text, path.string());
}

std::string charts_text(const std::vector<Chart>& charts) {
  std::string text = "{\"charts\": [";
  std::string separator = "\n  ";
  for (const auto& chart : charts) text += std::exchange(separator, ",\n  ") + chart_json(chart).dump();
  return text + "]}\n";
}

}  // namespace svchain::calibration
