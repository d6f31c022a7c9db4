#pragma once
// Where everything in the picture of a plan stands: a lane for each core from top to bottom, links in columns
// by rank from left to right, and edges as ways through free room between the boxes. Lengths in SVG units (px
// at 100 %). Internal to graph_svg.cpp.

#include <string>
#include <vector>

#include "framework/usecase/plan.h"

namespace svchain {

struct PortSpot {
  std::string name;
  double y = 0;
};

struct BoxSpot {
  double x = 0, y = 0, width = 0, height = 0;
  std::vector<PortSpot> inputs, outputs;  // connected ones, from top to bottom
};

struct LaneSpot {
  double y = 0, height = 0;
};

/// An edge passes each of its points horizontally, to the right or (on its way back) to the left.
struct WayPoint {
  double x = 0, y = 0;
  int direction = 1;
};

struct WaySpot {
  std::vector<WayPoint> points;
};

struct Layout {
  double width = 0, height = 0;
  std::vector<LaneSpot> lanes;  // by Plan::cores
  std::vector<BoxSpot> boxes;   // by Plan::links
  std::vector<WaySpot> ways;    // by Plan::edges
};

constexpr double kMargin = 16;
constexpr double kLaneLabelWidth = 92;
constexpr double kTitleHeight = 56;
constexpr double kLegendHeight = 40;
constexpr double kHeadHeight = 38;  // of a box: its name and type
constexpr double kPillWidth = 44;   // of an IPC end, between a box and its edge
constexpr double kPillGap = 5;

Layout lay_out(const Plan& plan);

}  // namespace svchain
