#include <cmath>
#include <limits>

#include "algorithms/calibration/charts.h"

namespace svchain::calibration {

namespace {

constexpr double kSamePlace = 1e-3;  // of a side

std::vector<ChartCorner> checkerboard_corners(const Chart& chart) {
  std::vector<ChartCorner> found;
  for (int j = 1; j < chart.squares[1]; ++j) {
    for (int i = 1; i < chart.squares[0]; ++i) {
      const Eigen::Vector2d place((i - chart.squares[0] / 2.0) * chart.side_m,
                                  (j - chart.squares[1] / 2.0) * chart.side_m);
      // The square at (-x, -y) of corner (1, 1) is black.
      found.push_back({place, static_cast<DarkQuarters>((i + j) % 2 == 0 ? 0b0101 : 0b1010), chart.side_m});
    }
  }
  return found;
}

/// Corners of black squares of side `side_m`, common ones once.
std::vector<ChartCorner> square_corners(const std::vector<Eigen::Vector2d>& centres, double side_m,
                                        double reach_m) {
  std::vector<ChartCorner> found;
  for (const auto& centre : centres) {
    for (size_t k = 0; k < 4; ++k) {
      ChartCorner corner = square_corner(centre, side_m, k);
      corner.reach_m = reach_m;
      ChartCorner* same = nullptr;
      for (auto& other : found) {
        if ((other.place_m - corner.place_m).norm() < kSamePlace * side_m) same = &other;
      }
      if (same)
        same->dark |= corner.dark;
      else
        found.push_back(corner);
    }
  }
  return found;
}

/// How far from a corner no square begins or ends other than those that meet there.
double clear_around(const ChartCorner& corner, const Chart& chart) {
  double clear = chart.side_m;
  for (const auto& centre : chart.centres_m) {
    const Eigen::Vector2d off = (centre - corner.place_m).cwiseAbs();
    const double gap = off.maxCoeff() - chart.side_m / 2;
    const bool meets = gap < kSamePlace * chart.side_m;
    if (!meets) clear = std::min(clear, gap);
  }
  return clear;
}

}  // namespace

ChartCorner square_corner(const Eigen::Vector2d& centre_m, double side_m, size_t number) {
  constexpr std::array<std::array<double, 2>, 4> kOutwards = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  constexpr std::array<DarkQuarters, 4> kInside = {0b0001, 0b0010, 0b0100, 0b1000};
  const auto& [x, y] = kOutwards[number];
  return {centre_m + side_m / 2 * Eigen::Vector2d(x, y), kInside[number], side_m};
}

std::vector<ChartCorner> corners(const Chart& chart) {
  switch (chart.type) {
    case ChartType::kCheckerboard:
      return checkerboard_corners(chart);
    case ChartType::kSquares: {
      auto found = square_corners(chart.centres_m, chart.side_m, chart.side_m);
      for (auto& corner : found) corner.reach_m = clear_around(corner, chart);
      return found;
    }
    case ChartType::kAprilTag36h11: {
      std::vector<Eigen::Vector2d> centres;
      for (const auto& tag : chart.tags) centres.push_back(tag.place_m);
      constexpr double kCellsAcross = 8;  // six of data and the border's two
      return square_corners(centres, chart.side_m, chart.side_m / kCellsAcross);
    }
  }
  return {};
}

}  // namespace svchain::calibration
