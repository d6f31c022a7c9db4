#include "framework/statistics/report_table.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

namespace svchain {

namespace {

using Json = nlohmann::json;
using Row = std::vector<std::string>;

std::string with_decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// A member as a table shows it; "" where there is none.
std::string cell(const Json& object, const char* key, int decimals = 2) {
  const auto it = object.find(key);
  if (it == object.end() || it->is_null()) return {};
  if (it->is_string()) return it->get<std::string>();
  return it->is_number_float() ? with_decimals(it->get<double>(), decimals) : it->dump();
}

const Json& part(const Json& object, const char* key) {
  static const Json kNone = Json::object();
  const auto it = object.find(key);
  return it == object.end() ? kNone : *it;
}

/// "late 3, downstream_full 1", or "" for none.
std::string counts(const Json& by_name) {
  std::string text;
  for (const auto& [name, count] : by_name.items()) {
    if (count != 0) text += (text.empty() ? "" : ", ") + name + " " + count.dump();
  }
  return text;
}

/// Columns as wide as they need; the first `left` ones from the left, the others from the right. Columns in
/// which no row has anything are left out.
std::string aligned(const std::vector<Row>& rows, size_t left) {
  std::vector<size_t> widths(rows.front().size());
  for (size_t c = 0; c < widths.size(); ++c) {
    for (size_t r = 1; r < rows.size(); ++r) widths[c] = std::max(widths[c], rows[r][c].size());
    if (widths[c] > 0) widths[c] = std::max(widths[c], rows[0][c].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (size_t c = 0; c < row.size(); ++c) {
      if (widths[c] == 0) continue;
      const std::string gap(widths[c] - row[c].size(), ' ');
      if (!line.empty()) line += "  ";
      line += c < left ? row[c] + gap : gap + row[c];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return rows.size() > 1 ? "\n" + text : "";
}

std::string headline(const Json& report) {
  const Json& frames = part(report, "frames");
  std::string text = cell(report, "usecase") + " on " + cell(report, "soc");
  if (frames.empty()) return text + "\n";
  text += ": " + cell(frames, "captured") + " frames captured, " + cell(frames, "delivered") + " delivered, ";
  const std::string dropped = counts(part(frames, "dropped"));
  text += dropped.empty() ? "none dropped" : "dropped: " + dropped;
  text += "; " + cell(report, "fps", 1) + " frames/s in " + cell(report, "wall_s") + " s\n";
  const Json& latency = part(part(report, "latency_ms"), "capture_to_display");
  if (!latency.empty()) {
    text += "capture to display: p50 " + cell(latency, "p50") + ", p99 " + cell(latency, "p99") + ", max " +
            cell(latency, "max") + " ms\n";
  }
  return text;
}

/// What a modelled run comes to once power-up is over.
std::string after_power_up(const Json& report) {
  const Json& after = part(report, "after_power_up");
  if (after.empty()) return {};
  std::string text = "modelled, from " + cell(after, "from_s") + " s on: " + cell(after, "fps") +
                     " frames/s, " + cell(after, "dropped") + " dropped";
  for (const auto& [name, core] : part(after, "cores").items())
    text += ", " + name + " " + with_decimals(100 * core.value("load", 0.0), 1) + " %";
  return text + "\n";
}

std::string cores(const Json& report) {
  std::vector<Row> rows = {{"core", "load %"}};
  for (const auto& [name, core] : part(report, "cores").items()) {
    rows.push_back({name, with_decimals(100 * core.value("load", 0.0), 1)});
  }
  return aligned(rows, 1);
}

std::string links(const Json& report) {
  std::vector<Row> rows = {{"link", "core", "processed", "process ms p50", "p99", "max",
                            "since capture ms p50", "p99", "max", "dropped"}};
  for (const auto& [name, link] : part(report, "links").items()) {
    const Json& process = part(link, "process_ms");
    const Json& latency = part(link, "latency_ms");
    rows.push_back({name, cell(link, "core"), cell(link, "processed"), cell(process, "p50"),
                    cell(process, "p99"), cell(process, "max"), cell(latency, "p50"), cell(latency, "p99"),
                    cell(latency, "max"), counts(part(link, "dropped"))});
  }
  return aligned(rows, 2);
}

std::string edges_between_cores(const Json& report) {
  std::vector<Row> rows = {{"edge between cores", "messages", "hop us p50", "p99", "full", "dropped"}};
  for (const auto& [name, edge] : part(report, "edges").items()) {
    if (!edge.value("ipc", false)) continue;
    const Json& hop = part(edge, "hop_us");
    rows.push_back({name, cell(edge, "messages"), cell(hop, "p50", 1), cell(hop, "p99", 1),
                    cell(edge, "full"), counts(part(edge, "dropped"))});
  }
  return aligned(rows, 1);
}

std::string pools(const Json& report) {
  std::vector<Row> rows = {{"pool", "buffers", "high water", "not returned", "held by"}};
  for (const auto& [name, pool] : part(report, "pools").items()) {
    const std::string missing = cell(pool, "outstanding_at_stop");
    rows.push_back({name, cell(pool, "buffers"), cell(pool, "high_water"), missing == "0" ? "" : missing,
                    counts(part(pool, "held_by"))});
  }
  return aligned(rows, 1);
}

std::string output(const Json& report) {
  const std::string path = cell(part(report, "output"), "path");
  return path.empty() ? "" : "\nwritten: " + path + "\n";
}

}  // namespace

std::string report_table(const nlohmann::json& report) {
  return headline(report) + after_power_up(report) + cores(report) + links(report) +
         edges_between_cores(report) + pools(report) + output(report);
}

}  // namespace svchain
