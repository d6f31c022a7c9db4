#include "usecases/svchain_page/bar_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "usecases/svchain_page/document.h"
#include "usecases/svchain_page/svg.h"

namespace svchain::page {

namespace {

constexpr double kMargin = 20, kPlotWidth = 470, kRow = 24, kBar = 13, kHeading = 34;
constexpr double kTop = 74, kBottom = 60;
constexpr int kNamePx = 12;
constexpr double kValueRoom = 50;  // right of the plot
constexpr const char* kPlainColour = "#4a7fb5";
constexpr const char* kMetColour = "#4f9a4d";
constexpr const char* kMissedColour = "#c0392b";

using Groups = std::vector<BarGroup>;

/// Ends of the axis, numbers of the 1-2-5 series.
struct Range {
  double from = 0.5, to = 2;
};

double next_125(double value, bool up) {
  const double unit = std::pow(10, std::floor(std::log10(value)));
  const double steps[] = {1, 2, 5, 10};
  if (up) return unit * *std::lower_bound(steps, steps + 4, value / unit * (1 - 1e-9));
  return unit * *(std::upper_bound(steps, steps + 4, value / unit * (1 + 1e-9)) - 1);
}

Range range_of(const Groups& groups) {
  double least = 1 / 1.5, most = 1.5;
  for (const BarGroup& group : groups)
    for (const Bar& bar : group.bars) {
      for (const double value : {bar.value, bar.quarter, bar.three_quarters, bar.goal.value_or(1)})
        if (!(value > 0)) throw std::invalid_argument(bar.name + ": a ratio above 0 was expected");
      least = std::min({least, bar.value, bar.quarter, bar.goal.value_or(1)});
      most = std::max({most, bar.value, bar.three_quarters, bar.goal.value_or(1)});
    }
  return {next_125(least, false), next_125(most, true)};
}

double name_room(const Groups& groups) {
  double room = 0;
  for (const BarGroup& group : groups)
    for (const Bar& bar : group.bars) room = std::max(room, text_width(bar.name, kNamePx));
  return room;
}

double height_of(const Groups& groups) {
  double height = kTop + kBottom;
  for (const BarGroup& group : groups) height += kHeading + kRow * static_cast<double>(group.bars.size());
  return height;
}

class Chart {
 public:
  Chart(const std::string& title, const Groups& groups)
      : range_(range_of(groups)),
        left_(kMargin + name_room(groups) + 8),
        bottom_(height_of(groups) - kBottom),
        svg_(std::max(left_ + kPlotWidth + kValueRoom + kMargin, 2 * kMargin + text_width(title, 18)),
             height_of(groups)) {
    svg_.text({kMargin, kMargin + 14}, title, {.size_px = 18, .bold = true});
  }

  std::string draw(const std::string& axis, const Groups& groups) {
    legend();
    grid(axis);
    double y = kTop;
    for (const BarGroup& group : groups) {
      svg_.rectangle({kMargin, y}, text_width(group.heading, kNamePx), kHeading - 4, kGround);
      svg_.text({kMargin, y + kHeading - 10}, group.heading,
                {.size_px = 12, .colour = kPaleInk, .bold = true});
      y += kHeading;
      for (const Bar& bar : group.bars) {
        draw(bar, y + kRow / 2);
        y += kRow;
      }
    }
    svg_.line({x_of(1), kTop}, {x_of(1), bottom_}, kInk, 1.2);
    return svg_.str();
  }

 private:
  double x_of(double value) const {
    return left_ + kPlotWidth * std::log(value / range_.from) / std::log(range_.to / range_.from);
  }

  void legend() {
    double x = kMargin;
    const double y = kMargin + 32;
    const auto entry = [&](const char* colour, const std::string& what) {
      svg_.rectangle({x, y - 9}, 12, 10, colour);
      svg_.text({x + 17, y}, what, {.size_px = 11, .colour = kPaleInk});
      x += 17 + text_width(what, 11) + 14;
    };
    entry(kMetColour, "goal met");
    entry(kMissedColour, "goal missed");
    entry(kPlainColour, "no goal");
    svg_.line({x, y - 9}, {x, y + 1}, kInk, 2.4);
    svg_.text({x + 6, y}, "goal", {.size_px = 11, .colour = kPaleInk});
    x += 50;
    svg_.line({x, y - 4}, {x + 22, y - 4}, kInk, 1.2);
    svg_.text({x + 27, y}, "half of the rounds", {.size_px = 11, .colour = kPaleInk});
  }

  void grid(const std::string& axis) {
    for (double at = range_.from; at <= range_.to * 1.001; at = next_125(at * 1.01, true)) {
      svg_.line({x_of(at), kTop}, {x_of(at), bottom_}, kGridColour, 1);
      svg_.text({x_of(at), bottom_ + 16}, axis_number(at),
                {.size_px = 11, .anchor = Anchor::kMiddle, .colour = kPaleInk});
    }
    svg_.text({left_ + kPlotWidth / 2, bottom_ + 40}, axis, {.size_px = 12, .anchor = Anchor::kMiddle});
  }

  void draw(const Bar& bar, double y) {
    const char* const colour = !bar.goal ? kPlainColour : bar.met ? kMetColour : kMissedColour;
    const double from = x_of(std::min(1.0, bar.value)), to = x_of(std::max(1.0, bar.value));
    svg_.text({left_ - 8, y + 4}, bar.name, {.size_px = kNamePx, .anchor = Anchor::kEnd});
    svg_.rectangle({from, y - kBar / 2}, to - from, kBar, colour);
    svg_.line({x_of(bar.quarter), y}, {x_of(bar.three_quarters), y}, kInk, 1.2);
    if (bar.goal)
      svg_.line({x_of(*bar.goal), y - kBar / 2 - 3}, {x_of(*bar.goal), y + kBar / 2 + 3}, kInk, 2.4);
    svg_.text({left_ + kPlotWidth + kValueRoom, y + 4}, figure(bar.value),
              {.size_px = kNamePx, .anchor = Anchor::kEnd, .colour = bar.goal ? colour : kInk, .bold = true});
  }

  Range range_;
  double left_, bottom_;
  Svg svg_;
};

}  // namespace

std::string bar_chart(const std::string& title, const std::string& axis, const Groups& groups) {
  Groups filled;
  std::copy_if(groups.begin(), groups.end(), std::back_inserter(filled),
               [](const BarGroup& group) { return !group.bars.empty(); });
  return Chart(title, filled).draw(axis, filled);
}

}  // namespace svchain::page
