#include "algorithms/calibration/print_charts.h"

#include <algorithm>
#include <cstdio>
#include <opencv2/aruco.hpp>

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;

struct Rectangle {
  Vector2d low, high;
};

constexpr double kLargestFontM = 0.012;
constexpr double kWidestCharacter = 0.65;  // of the font's height, a little more than letters are on average

std::vector<Rectangle> checkerboard_squares(const Chart& chart) {
  std::vector<Rectangle> black;
  const Vector2d low = -chart.side_m / 2 * Vector2d(chart.squares[0], chart.squares[1]);
  for (int j = 0; j < chart.squares[1]; ++j) {
    for (int i = j % 2; i < chart.squares[0]; i += 2) {
      black.push_back({low + chart.side_m * Vector2d(i, j), low + chart.side_m * Vector2d(i + 1, j + 1)});
    }
  }
  return black;
}

std::vector<Rectangle> separate_squares(const Chart& chart) {
  std::vector<Rectangle> black;
  const Vector2d half = Vector2d::Constant(chart.side_m / 2);
  for (const auto& centre : chart.centres_m) black.push_back({centre - half, centre + half});
  return black;
}

/// The black cells of a tag, those side by side in one.
void add_tag(const Tag& tag, double side_m, std::vector<Rectangle>& black) {
  constexpr int kCells = 8;  // six of data and the border's two
  cv::Mat cells;             // one pixel each, the upper left one first
  cv::aruco::drawMarker(cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11), tag.id, kCells,
                        cells);
  const double cell_m = side_m / kCells;
  const Vector2d upper_left = tag.place_m + side_m / 2 * Vector2d(-1, 1);
  for (int row = 0; row < kCells; ++row) {
    const auto dark = [&](int column) { return column < kCells && cells.at<uint8_t>(row, column) == 0; };
    for (int column = 0; column < kCells; ++column) {
      const int first = column;
      while (dark(column)) ++column;
      if (column > first)
        black.push_back(
            {upper_left + cell_m * Vector2d(first, -row - 1), upper_left + cell_m * Vector2d(column, -row)});
    }
  }
}

std::vector<Rectangle> black_of(const Chart& chart) {
  switch (chart.type) {
    case ChartType::kCheckerboard:
      return checkerboard_squares(chart);
    case ChartType::kSquares:
      return separate_squares(chart);
    case ChartType::kAprilTag36h11:
      break;
  }
  std::vector<Rectangle> black;
  for (const auto& tag : chart.tags) add_tag(tag, chart.side_m, black);
  return black;
}

/// All that the chart covers, white squares at its corners included.
Rectangle extent(const Chart& chart, const std::vector<Rectangle>& black) {
  if (chart.type == ChartType::kCheckerboard) {
    const Vector2d half = chart.side_m / 2 * Vector2d(chart.squares[0], chart.squares[1]);
    return {-half, half};
  }
  Rectangle all = black.front();
  for (const auto& one : black) all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  return all;
}

/// What every font has: ASCII, and for any other character a question mark.
std::string plain(const std::string& utf8) {
  std::string made;
  for (const char c : utf8) {
    const bool continues = (c & 0xC0) == 0x80;  // a character of several bytes
    if (!continues) made += c >= ' ' && c <= '~' ? c : '?';
  }
  return made;
}

std::string centimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", metres * 100);
  return text;
}

std::string description(const Chart& chart) {
  const std::string size = " of " + centimetres(chart.side_m) + " cm";
  switch (chart.type) {
    case ChartType::kCheckerboard:
      return "checkerboard, " + std::to_string(chart.squares[0]) + " x " + std::to_string(chart.squares[1]) +
             " squares" + size;
    case ChartType::kSquares:
      return std::to_string(chart.centres_m.size()) + " squares" + size;
    case ChartType::kAprilTag36h11:
      break;
  }
  return std::to_string(chart.tags.size()) + " AprilTags 36h11" + size;
}

/// An arrow to the right with its tail's middle at `tail`.
std::vector<Vector2d> arrow(const Vector2d& tail, double length_m, double height_m) {
  std::vector<Vector2d> outline;
  constexpr double kShape[][2] = {{0, -0.1},  {0.6, -0.1}, {0.6, -0.4}, {1, 0},
                                  {0.6, 0.4}, {0.6, 0.1},  {0, 0.1}};
  for (const auto& [along, across] : kShape)
    outline.emplace_back(tail + Vector2d(along * length_m, across * height_m));
  return outline;
}

}  // namespace

Sheet sheet_of(const Chart& chart) {
  const auto black = black_of(chart);
  const Rectangle all = extent(chart, black);
  const Vector2d paper = all.high - all.low + Vector2d::Constant(chart.side_m);
  const std::string what = plain(chart.name) + ": " + description(chart);
  const std::string size = "Print at 100 %: this sheet is " + centimetres(paper.x()) + " cm wide";
  const std::string x = "x: ahead where the chart's yaw is 0";
  const double characters = static_cast<double>(std::max({what.size(), size.size(), x.size() + 5})) + 2;
  const double font_m = std::min(kLargestFontM, paper.x() / (kWidestCharacter * characters));
  const double labels_m = 5.5 * font_m;

  Sheet sheet;
  sheet.name = chart.name;
  sheet.size_m = paper + Vector2d(0, labels_m);
  const Vector2d shift = Vector2d(chart.side_m / 2, chart.side_m / 2 + labels_m) - all.low;
  for (const auto& one : black) {
    const Vector2d low = one.low + shift;
    const Vector2d high = one.high + shift;
    sheet.black.push_back({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
  }
  sheet.black.push_back(arrow({font_m, 4.35 * font_m}, 2.5 * font_m, font_m));
  sheet.labels = {{{4 * font_m, 4 * font_m}, font_m, x},
                  {{font_m, 2.5 * font_m}, font_m, what},
                  {{font_m, font_m}, font_m, size}};
  return sheet;
}

Chart usual_chart() {
  Chart chart;
  chart.name = "board";
  chart.squares = {5, 4};
  chart.side_m = 0.25;
  return chart;
}

}  // namespace svchain::calibration
