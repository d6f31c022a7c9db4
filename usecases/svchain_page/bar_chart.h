#pragma once
// Ratios as bars to the right and left of 1, on a logarithmic axis, each with where half of its rounds lie
// and its goal. Pure function.

#include <optional>
#include <string>
#include <vector>

namespace svchain::page {

struct Bar {
  std::string name;
  double value = 1, quarter = 1, three_quarters = 1;
  std::optional<double> goal;
  bool met = true;
};

/// Bars that belong together, under a heading that says which way is better.
struct BarGroup {
  std::string heading;
  std::vector<Bar> bars;
};

/// SVG. Groups without bars are left out. Throws std::invalid_argument, naming the bar, for a value that is
/// not above 0.
std::string bar_chart(const std::string& title, const std::string& axis, const std::vector<BarGroup>& groups);

}  // namespace svchain::page
