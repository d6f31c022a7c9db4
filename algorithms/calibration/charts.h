#pragma once
// What lies on the ground during calibration (contracts: "Charts"), and the corners on it that pictures are
// measured by. A chart's frame: its centre, x and y on the ground, metres, z = 0. Plain values.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/pose2.h"
#include "algorithms/json/fault.h"

namespace svchain::calibration {

enum class ChartType { kCheckerboard, kSquares, kAprilTag36h11 };

struct Tag {
  int id = 0;
  Eigen::Vector2d place_m = {0, 0};  // of its middle
};

struct Chart {
  std::string name;
  ChartType type = ChartType::kCheckerboard;
  std::array<int, 2> squares = {0, 0};  // checkerboard: along x and y
  double side_m = 0;                    // of a checkerboard's square, a single square, a tag's black border
  std::vector<Eigen::Vector2d> centres_m;             // squares: of each black one
  std::vector<Tag> tags;                              // apriltag_36h11
  std::optional<geometry::Pose2> vehicle_from_chart;  // missing: to be found by the calibration
};

/// Quarters of the surroundings of a corner that are black: bit 0 (+x, +y), bit 1 (-x, +y), bit 2 (-x, -y),
/// bit 3 (+x, -y) in the chart's frame. Two opposite ones make a saddle, any other number a bend.
using DarkQuarters = uint8_t;

struct ChartCorner {
  Eigen::Vector2d place_m = {0, 0};  // in the chart's frame
  DarkQuarters dark = 0;
  double reach_m = 0;  // half the side of the square around it that shows these quarters and nothing else

  bool is_saddle() const { return dark == 0b0101 || dark == 0b1010; }
};

/// Corner 0 to 3 of a black square, counter-clockwise from (-x, -y), as far as it reaches at most.
ChartCorner square_corner(const Eigen::Vector2d& centre_m, double side_m, size_t number);

/// Every corner of a chart, in the order in which files and reports count them: a checkerboard's inner
/// corners along x, then y, from (-x, -y); the corners of squares in the order of `centres_m`, each
/// counter-clockwise from (-x, -y), where squares touch the common corner once, by its first square; of tags
/// likewise.
std::vector<ChartCorner> corners(const Chart& chart);

/// Reads a charts file, with every fault in it.
Result<std::vector<Chart>> read_charts(const std::filesystem::path& path);
Result<std::vector<Chart>> parse_charts(const std::string& text, const std::string& file);
/// The charts as the text of a charts file.
std::string charts_text(const std::vector<Chart>& charts);

}  // namespace svchain::calibration
