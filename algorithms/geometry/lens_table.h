#pragma once
// What a lens maker prints: field angle against image height, from the axis outwards. Plain value.

#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "algorithms/geometry/monotone_curve.h"
#include "algorithms/json/fault.h"

namespace svchain::geometry {

struct LensTable {
  std::vector<double> angle_deg;
  std::vector<double> height_mm;
};

/// A column of a table file: the name in its header line, or its number from 0.
using TableColumn = std::variant<std::string, size_t>;

struct TableColumns {
  TableColumn angle;
  TableColumn height;
};

/// What is wrong with one number of a table, or with the table as a whole.
struct TableFault {
  static constexpr size_t kWholeTable = std::numeric_limits<size_t>::max();
  size_t row = kWholeTable;
  bool in_height = false;
  std::string message;
};

/// A few rows at fault are listed, of many only the first ones. Empty where a lens can be made of the table.
std::vector<TableFault> table_faults(const LensTable& table);

/// Reads text with one row a line, columns parted by tabs, semicolons, commas or else blanks, with or without
/// a header line. Faults carry the line. Other columns may hold anything.
Result<LensTable> read_lens_table(const std::filesystem::path& path, const TableColumns& columns);

/// Angle (rad) -> height (mm). Heights are printed rounded: a run of equal ones is one node at the mean of
/// its angles, and the axis (0, 0) is added. The table must be free of faults.
MonotoneCurve lens_curve(const LensTable& table);

}  // namespace svchain::geometry
