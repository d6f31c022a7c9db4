#pragma once
// How a cost grows: lines through measured points; x doubles from mark to mark, y begins at 0 or doubles as
// well. Pure function.

#include <string>
#include <vector>

#include "usecases/svchain_page/svg.h"

namespace svchain::page {

struct Series {
  std::string name;
  std::vector<Point> points;
};

struct LinePlot {
  std::string title, x_axis, y_axis;  // axes with their units
  std::vector<Series> series;
  bool doubling_y = false;
};

/// SVG, a mark on the x axis for every x of the points. Series without points are left out. Throws
/// std::invalid_argument, naming the series, for an x (or a y, where it doubles) that is not above 0.
std::string line_plot(const LinePlot& plot);

}  // namespace svchain::page
