#include "algorithms/geometry/lens_json.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/table_lens.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr json::Range kFocalPx{1, 100000};
constexpr json::Range kCentrePx{-20000, 40000};
constexpr json::Range kCoefficient{-1e6, 1e6};
constexpr json::Range kPixelUm{0.1, 100};
constexpr json::Range kMaxAngleDeg{1, 180};

Eigen::Vector2d pair(const json::Value& value, json::Range range) {
  const auto numbers = value.numbers(2, range);
  return {numbers[0], numbers[1]};
}

ordered_json pair(const Eigen::Vector2d& v) {
  return {v.x(), v.y()};
}

/// The largest angle a file asks for; where it asks for none, the usual one.
double max_angle_rad(const json::Value& lens) {
  const auto given = lens.optional("max_angle_deg");
  return given ? radians(given.number(kMaxAngleDeg, degrees(kUsualMaxAngleRad))) : kUsualMaxAngleRad;
}

/// Degrees that read back as exactly this angle, in as few digits as will do.
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

/// A lens made of faultless values, unless the file asks for a larger angle than the model can serve.
LensPtr within_its_limit(LensPtr made, const json::Value& lens, const std::string& limit) {
  const auto given = lens.optional("max_angle_deg");
  constexpr double kRoundingDeg = 1e-9;
  const double widest_deg = degrees(made->max_angle_rad());
  if (!given || given.json().get<double>() <= widest_deg + kRoundingDeg) return made;
  char text[96];
  std::snprintf(text, sizeof text, "expected at most %.4f, where %s, got %g", widest_deg, limit.c_str(),
                given.json().get<double>());
  given.fault(text);
  return nullptr;
}

LensPtr read_kannala_brandt(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "focal_px", "centre_px", "k", "max_angle_deg"});
  const auto focal_px = pair(lens.required("focal_px"), kFocalPx);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const auto k = lens.required("k").numbers(4, kCoefficient);
  const double widest = max_angle_rad(lens);
  if (lens.fault_count() > before) return nullptr;
  return within_its_limit(
      std::make_shared<KannalaBrandt>(focal_px, centre_px, std::array{k[0], k[1], k[2], k[3]}, widest), lens,
      "the image height stops rising");
}

ordered_json write_kannala_brandt(const Lens& lens) {
  const auto& made = dynamic_cast<const KannalaBrandt&>(lens);
  return {{"model", made.model()},
          {"focal_px", pair(made.focal_px())},
          {"centre_px", pair(made.centre_px())},
          {"k", made.k()},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

std::optional<TableColumn> read_column(const json::Value& column) {
  if (!column) return std::nullopt;
  if (column.is_string()) return TableColumn(column.string());
  constexpr double kMostColumns = 1000;
  if (column.is_number()) return TableColumn(static_cast<size_t>(column.integer({0, kMostColumns})));
  column.fault("expected a column's name or its number from 0");
  return std::nullopt;
}

/// The table in a file beside the rig.
std::optional<LensTable> read_table_file(const json::Value& lens) {
  for (const char* key : {"angle_deg", "height_mm"}) {
    lens.optional(key).fault("expected either \"file\" or \"angle_deg\" and \"height_mm\", not both");
  }
  const auto columns = lens.required("columns");
  columns.only({"angle", "height"});
  const auto angle = read_column(columns.required("angle"));
  const auto height = read_column(columns.required("height"));
  const auto name = lens.optional("file");
  const auto file = name.string();
  if (!angle || !height || !name.is_string()) return std::nullopt;
  auto table = read_lens_table(lens.document().folder() / file, {*angle, *height});
  if (table) return std::move(*table);
  for (auto& fault : table.error()) lens.add_fault(std::move(fault));
  return std::nullopt;
}

/// The table written into the rig itself.
std::optional<LensTable> read_inline_table(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.optional("columns").fault("means nothing without \"file\"");
  const auto angles = lens.required("angle_deg");
  const auto heights = lens.required("height_mm");
  LensTable table;
  for (const auto& item : angles.items()) table.angle_deg.push_back(item.number());
  for (const auto& item : heights.items()) table.height_mm.push_back(item.number());
  if (lens.fault_count() > before) return std::nullopt;
  for (const auto& fault : table_faults(table)) {
    const auto& column = fault.in_height ? heights : angles;
    (fault.row == TableFault::kWholeTable ? column : column.items()[fault.row]).fault(fault.message);
  }
  if (lens.fault_count() > before) return std::nullopt;
  return table;
}

LensPtr read_table(const json::Value& lens) {
  const size_t before = lens.fault_count();
  lens.only({"model", "angle_deg", "height_mm", "file", "columns", "pixel_um", "centre_px", "max_angle_deg"});
  const double pixel_um = lens.required("pixel_um").number(kPixelUm);
  const auto centre_px = pair(lens.required("centre_px"), kCentrePx);
  const double widest = max_angle_rad(lens);
  auto table = lens.optional("file") ? read_table_file(lens) : read_inline_table(lens);
  if (!table || lens.fault_count() > before) return nullptr;
  return within_its_limit(std::make_shared<TableLens>(std::move(*table), pixel_um, centre_px, widest), lens,
                          "the table ends");
}

ordered_json write_table(const Lens& lens) {
  const auto& made = dynamic_cast<const TableLens&>(lens);
  return {{"model", made.model()},
          {"angle_deg", made.table().angle_deg},
          {"height_mm", made.table().height_mm},
          {"pixel_um", made.pixel_um()},
          {"centre_px", pair(made.centre_px())},
          {"max_angle_deg", exact_degrees(made.max_angle_rad())}};
}

/// Every lens model there is. A new one adds its two functions above and its line here.
struct Model {
  std::string name;
  LensPtr (*read)(const json::Value&);
  ordered_json (*write)(const Lens&);
};

const std::vector<Model>& models() {
  static const std::vector<Model> kModels = {
      {"kannala_brandt", read_kannala_brandt, write_kannala_brandt},
      {"table", read_table, write_table},
  };
  return kModels;
}

const Model* find_model(const std::string& name) {
  for (const auto& model : models()) {
    if (model.name == name) return &model;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> lens_models() {
  std::vector<std::string> names;
  for (const auto& model : models()) names.push_back(model.name);
  return names;
}

LensPtr read_lens(const json::Value& lens) {
  const auto* model = find_model(lens.required("model").choice(lens_models()));
  return model ? model->read(lens) : nullptr;
}

ordered_json lens_json(const Lens& lens) {
  return find_model(lens.model())->write(lens);
}

}  // namespace svchain::geometry
