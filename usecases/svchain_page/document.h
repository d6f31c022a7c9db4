#pragma once
// A page of prose and tables in Markdown. Plain values.

#include <optional>
#include <string>
#include <vector>

namespace svchain::page {

struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// Prose, then tables.
struct Section {
  std::string title;
  std::string prose;
  std::vector<Table> tables;
};

/// A heading of the second order and what is under it.
std::string markdown(const Section& section);

/// A number as a table shows it, two or three digits; "-" for none.
std::string figure(double value);
std::string figure(std::optional<double> value);
/// Whether a figure is within its limit: "yes" or "**no**".
std::string met(double value, double limit);

}  // namespace svchain::page
