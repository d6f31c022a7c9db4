#include "usecases/svchain_page/document.h"

#include <cmath>
#include <cstdio>

namespace svchain::page {

namespace {

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const auto& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

std::string table_text(const Table& table) {
  std::string text = row_of(table.head);
  text += row_of(std::vector<std::string>(table.head.size(), "---"));
  for (const auto& row : table.rows) text += row_of(row);
  return text;
}

}  // namespace

std::string markdown(const Section& section) {
  std::string text = "## " + section.title + "\n\n" + section.prose;
  for (const auto& table : section.tables) text += "\n" + table_text(table);
  return text + "\n";
}

std::string figure(double value) {
  char text[32];
  const double size = std::abs(value);
  const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 ? 2 : size >= 0.01 ? 3 : 4;
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string figure(std::optional<double> value) {
  return value ? figure(*value) : "-";
}

std::string met(double value, double limit) {
  return value <= limit ? "yes" : "**no**";
}

}  // namespace svchain::page
