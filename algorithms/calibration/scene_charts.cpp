#include "algorithms/calibration/scene_charts.h"

namespace svchain::calibration {

std::vector<Chart> charts_of(const scene::Scene& scene) {
  std::vector<Chart> charts;
  for (const auto& board : scene.charts) {
    Chart chart;
    chart.name = board.name;
    chart.squares = board.squares;
    chart.side_m = board.square_m;
    chart.vehicle_from_chart = board.world_from_chart;
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace svchain::calibration
