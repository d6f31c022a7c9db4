#include "usecases/svchain_page/line_plot.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace svchain::page {

namespace {

constexpr double kMargin = 20, kLeft = 84, kTop = 84, kBottom = 64;
constexpr double kPlotWidth = 560, kPlotHeight = 280;
constexpr const char* kColours[] = {"#4a7fb5", "#c58a2c", "#4f9a4d", "#bb5a78", "#7d5fb2"};

/// From the lowest to the highest mark.
struct Axis {
  std::vector<double> marks;
  bool doubles = false;

  double share(double value) const {
    const double from = marks.front(), to = marks.back();
    if (from == to) return 0.5;
    return doubles ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
  }
};

Axis x_axis(const LinePlot& plot) {
  std::set<double> marks;
  for (const Series& series : plot.series)
    for (const Point& point : series.points) {
      if (!(point.x > 0)) throw std::invalid_argument(series.name + ": x above 0 was expected");
      marks.insert(point.x);
    }
  return {{marks.begin(), marks.end()}, true};
}

Axis doubling_axis(double least, double most) {
  Axis axis{{}, true};
  const double last = std::exp2(std::ceil(std::log2(most)));
  for (double mark = std::exp2(std::floor(std::log2(least))); mark <= last; mark *= 2)
    axis.marks.push_back(mark);
  return axis;
}

/// About five steps of 1, 2 or 5 times a power of ten.
Axis axis_from_zero(double most) {
  const double unit = std::pow(10, std::floor(std::log10(most / 5)));
  const double rough = most / 5 / unit;
  const double step = unit * (rough <= 1 ? 1 : rough <= 2 ? 2 : rough <= 5 ? 5 : 10);
  Axis axis;
  for (int i = 0; (i - 1) * step < most; ++i) axis.marks.push_back(i * step);
  return axis;
}

Axis y_axis(const LinePlot& plot) {
  double least = INFINITY, most = 0;
  for (const Series& series : plot.series)
    for (const Point& point : series.points) {
      if (plot.doubling_y && !(point.y > 0))
        throw std::invalid_argument(series.name + ": y above 0 was expected");
      least = std::min(least, point.y);
      most = std::max(most, point.y);
    }
  if (most <= 0) most = 1;
  return plot.doubling_y ? doubling_axis(std::min(least, most), most) : axis_from_zero(most);
}

class Drawing {
 public:
  explicit Drawing(const LinePlot& plot)
      : x_(x_axis(plot)),
        y_(y_axis(plot)),
        svg_(kLeft + kPlotWidth + 2 * kMargin, kTop + kPlotHeight + kBottom) {
    if (x_.marks.empty()) x_.marks = {1};
  }

  std::string draw(const LinePlot& plot) {
    svg_.text({kMargin, kMargin + 14}, plot.title, {.size_px = 18, .bold = true});
    axes(plot);
    double legend_x = kMargin;
    size_t colour = 0;
    for (const Series& series : plot.series) {
      if (series.points.empty()) continue;
      draw(series, kColours[colour++ % std::size(kColours)], legend_x);
    }
    return svg_.str();
  }

 private:
  Point place(const Point& point) const {
    return {kLeft + kPlotWidth * x_.share(point.x), kTop + kPlotHeight * (1 - y_.share(point.y))};
  }

  void axes(const LinePlot& plot) {
    const double right = kLeft + kPlotWidth, bottom = kTop + kPlotHeight;
    for (const double mark : y_.marks) {
      const double y = place({x_.marks.front(), mark}).y;
      svg_.line({kLeft, y}, {right, y}, kGridColour, 1);
      svg_.text({kLeft - 8, y + 4}, axis_number(mark),
                {.size_px = 11, .anchor = Anchor::kEnd, .colour = kPaleInk});
    }
    for (const double mark : x_.marks) {
      const double x = place({mark, y_.marks.front()}).x;
      svg_.line({x, bottom}, {x, bottom + 5}, kPaleInk, 1);
      svg_.text({x, bottom + 19}, axis_number(mark),
                {.size_px = 11, .anchor = Anchor::kMiddle, .colour = kPaleInk});
    }
    svg_.line({kLeft, bottom}, {right, bottom}, kPaleInk, 1.2);
    svg_.text({kLeft + kPlotWidth / 2, bottom + 44}, plot.x_axis, {.anchor = Anchor::kMiddle});
    svg_.text({kMargin + 10, kTop + kPlotHeight / 2}, plot.y_axis,
              {.anchor = Anchor::kMiddle, .upwards = true});
  }

  /// With its entry in the legend, which goes on to the right.
  void draw(const Series& series, const char* colour, double& legend_x) {
    const double y = kMargin + 36;
    svg_.line({legend_x, y - 4}, {legend_x + 22, y - 4}, colour, 2);
    svg_.dot({legend_x + 11, y - 4}, 3.2, colour);
    svg_.text({legend_x + 28, y}, series.name, {.colour = kPaleInk});
    legend_x += 28 + text_width(series.name, 12) + 12;
    std::vector<Point> points;
    for (const Point& point : series.points) points.push_back(place(point));
    svg_.polyline(points, colour, 2);
    for (const Point& point : points) svg_.dot(point, 3.2, colour);
  }

  Axis x_, y_;
  Svg svg_;
};

}  // namespace

std::string line_plot(const LinePlot& plot) {
  return Drawing(plot).draw(plot);
}

}  // namespace svchain::page
