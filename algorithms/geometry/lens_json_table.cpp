// `table` in rig files.

#include <nlohmann/json.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/lens_models.h"
#include "algorithms/geometry/table_lens.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr json::Range kPixelUm{0.1, 100};

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

}  // namespace

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

}  // namespace svchain::geometry
