#include "algorithms/geometry/lens_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "algorithms/geometry/angles.h"

namespace svchain::geometry {

namespace {

constexpr size_t kFewestNodes = 4;
constexpr size_t kMostFaults = 10;
constexpr size_t kMostRows = 100000;
constexpr double kWidestAngleDeg = 180;
constexpr double kTallestMm = 100;

std::string shown(double v) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, v).ptr};
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

/// The cells of one line, parted by the strongest separator that the line holds.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) == std::string_view::npos) continue;
    for (size_t from = 0; from <= line.size();) {
      const size_t to = std::min(line.find(separator, from), line.size());
      cells.emplace_back(trimmed(line.substr(from, to - from)));
      from = to + 1;
    }
    return cells;
  }
  for (size_t from = line.find_first_not_of(' '); from < line.size();) {
    const size_t to = std::min(line.find(' ', from), line.size());
    cells.emplace_back(trimmed(line.substr(from, to - from)));
    from = std::min(line.find_first_not_of(' ', to), line.size());
  }
  return cells;
}

std::optional<double> number_in(const std::string& cell) {
  double v = 0;
  const char* end = cell.data() + cell.size();
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, end, v);
  if (error != std::errc() || stop != end || !std::isfinite(v)) return std::nullopt;
  return v;
}

bool is_header(const std::vector<std::string>& cells) {
  return std::none_of(cells.begin(), cells.end(),
                      [](const auto& cell) { return number_in(cell).has_value(); });
}

/// Collects the faults of one table file: the first few by line, the rest by their number.
class FileFaults {
 public:
  explicit FileFaults(std::string file) : file_(std::move(file)) {}

  void add(int line, std::string message) {
    ++count_;
    if (faults_.size() < kMostFaults)
      faults_.push_back({file_, {line, line > 0 ? 1 : 0}, {}, std::move(message)});
  }
  bool none() const { return count_ == 0; }
  tl::unexpected<Faults> take() {
    if (const size_t more = count_ - faults_.size(); more > 0) {
      faults_.push_back({file_, {}, {}, std::to_string(more) + " more faults of this kind"});
    }
    return tl::unexpected(std::move(faults_));
  }

 private:
  std::string file_;
  Faults faults_;
  size_t count_ = 0;
};

/// Number of the column, or nothing after a fault.
std::optional<size_t> find_column(const TableColumn& column, const std::vector<std::string>& header, int line,
                                  FileFaults& faults) {
  if (const auto* number = std::get_if<size_t>(&column)) return *number;
  const auto& name = std::get<std::string>(column);
  const auto found = std::find(header.begin(), header.end(), name);
  if (found != header.end()) return static_cast<size_t>(found - header.begin());
  const std::string known =
      header.empty() ? " (there is no header line)" : " (known: " + spoken_list(header) + ")";
  faults.add(line, "no column \"" + name + "\"" + did_you_mean(name, header) + known);
  return std::nullopt;
}

struct ColumnNumbers {
  size_t angle;
  size_t height;
};

std::optional<ColumnNumbers> find_columns(const TableColumns& columns, const std::vector<std::string>& header,
                                          int line, FileFaults& faults) {
  const auto angle = find_column(columns.angle, header, line, faults);
  const auto height = find_column(columns.height, header, line, faults);
  if (!angle || !height) return std::nullopt;
  return ColumnNumbers{*angle, *height};
}

/// Appends one row to the table, or faults it.
void read_row(const std::vector<std::string>& cells, ColumnNumbers columns, int line, LensTable& table,
              FileFaults& faults) {
  const size_t needed = std::max(columns.angle, columns.height) + 1;
  if (cells.size() < needed) {
    faults.add(line, "expected at least " + std::to_string(needed) + " columns, got " +
                         std::to_string(cells.size()));
    return;
  }
  const auto angle_deg = number_in(cells[columns.angle]);
  const auto height_mm = number_in(cells[columns.height]);
  if (!angle_deg) faults.add(line, "angle expected as a number, got \"" + cells[columns.angle] + "\"");
  if (!height_mm) faults.add(line, "height expected as a number, got \"" + cells[columns.height] + "\"");
  if (!angle_deg || !height_mm) return;
  table.angle_deg.push_back(*angle_deg);
  table.height_mm.push_back(*height_mm);
}

}  // namespace

std::vector<TableFault> table_faults(const LensTable& table) {
  std::vector<TableFault> faults;
  size_t count = 0;
  const auto add = [&](size_t row, bool in_height, std::string message) {
    if (++count <= kMostFaults) faults.push_back({row, in_height, std::move(message)});
  };
  if (table.angle_deg.size() != table.height_mm.size()) {
    add(TableFault::kWholeTable, false,
        "as many heights as angles expected, got " + std::to_string(table.angle_deg.size()) + " angles and " +
            std::to_string(table.height_mm.size()) + " heights");
    return faults;
  }
  for (size_t i = 0; i < table.angle_deg.size(); ++i) {
    const double angle = table.angle_deg[i];
    const double height = table.height_mm[i];
    if (!(angle >= 0 && angle <= kWidestAngleDeg)) {
      add(i, false, "angle expected from 0 to 180 degrees, got " + shown(angle));
    } else if (i > 0 && !(angle > table.angle_deg[i - 1])) {
      add(i, false, "angles must rise: " + shown(angle) + " after " + shown(table.angle_deg[i - 1]));
    }
    if (!(height >= 0 && height <= kTallestMm)) {
      add(i, true, "height expected from 0 to 100 mm, got " + shown(height));
    } else if (i > 0 && height < table.height_mm[i - 1]) {
      add(i, true, "heights must not fall: " + shown(height) + " after " + shown(table.height_mm[i - 1]));
    } else if (angle == 0 && height > 0) {
      add(i, true, "height expected 0 at angle 0, got " + shown(height));
    }
  }
  if (!faults.empty()) return faults;
  size_t nodes = 1;  // the axis
  double last = 0;
  for (const double height : table.height_mm) {
    if (height != last) ++nodes;
    last = height;
  }
  if (nodes < kFewestNodes) {
    add(TableFault::kWholeTable, false,
        "a lens needs at least " + std::to_string(kFewestNodes) +
            " different heights, the axis included, got " + std::to_string(nodes));
  }
  return faults;
}

Result<LensTable> read_lens_table(const std::filesystem::path& path, const TableColumns& columns) {
  std::error_code error;
  std::ifstream in(path);
  if (!in || !std::filesystem::is_regular_file(path, error)) {
    return fail(path.string(), "cannot be read, expected a table of angles and image heights");
  }
  FileFaults faults(path.string());
  LensTable table;
  std::vector<int> lines;  // of the rows
  std::optional<ColumnNumbers> numbers;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (trimmed(text).empty() || text.starts_with('#')) continue;
    const auto cells = cells_of(text);
    const bool header = !numbers && is_header(cells);
    if (!numbers) numbers = find_columns(columns, header ? cells : std::vector<std::string>(), line, faults);
    if (!numbers) return faults.take();
    if (header) continue;
    read_row(cells, *numbers, line, table, faults);
    lines.resize(table.angle_deg.size(), line);
    if (lines.size() > kMostRows)
      return fail(path.string(), "more than " + std::to_string(kMostRows) + " rows");
  }
  if (!faults.none()) return faults.take();
  for (auto& fault : table_faults(table)) {
    faults.add(fault.row == TableFault::kWholeTable ? 0 : lines[fault.row], std::move(fault.message));
  }
  if (!faults.none()) return faults.take();
  return table;
}

MonotoneCurve lens_curve(const LensTable& table) {
  std::vector<double> angle_rad{0};
  std::vector<double> height_mm{0};
  const auto& heights = table.height_mm;
  for (size_t first = 0, last = 0; first < heights.size(); first = last) {
    double sum = 0;
    for (last = first; last < heights.size() && heights[last] == heights[first]; ++last)
      sum += table.angle_deg[last];
    if (heights[first] == 0) continue;  // the axis itself
    angle_rad.push_back(radians(sum / static_cast<double>(last - first)));
    height_mm.push_back(heights[first]);
  }
  return {std::move(angle_rad), std::move(height_mm)};
}

}  // namespace svchain::geometry
