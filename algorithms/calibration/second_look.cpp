#include "algorithms/calibration/second_look.h"

#include <algorithm>

#include "algorithms/calibration/corner_fit.h"

namespace svchain::calibration {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNear = 0.2;  // of a corner's shorter edge: farther off, it is another corner

}  // namespace

const SeenCorner* find(const std::vector<SeenCorner>& corners, size_t camera, size_t chart, int corner) {
  for (const auto& seen : corners) {
    if (seen.camera == camera && seen.chart == chart && seen.corner == corner) return &seen;
  }
  return nullptr;
}

std::optional<ExpectedCorner> expect(const geometry::Camera& camera, const ChartCorner& corner,
                                     const geometry::Pose2& vehicle_from_chart) {
  constexpr double kShare = 0.05;  // of the reach, over which the picture is taken to be even
  const auto see = [&](const Vector2d& place_m) {
    const Vector2d ground = vehicle_from_chart * place_m;
    return camera.see(Vector3d(ground.x(), ground.y(), 0));
  };
  const double step_m = kShare * corner.reach_m;
  const auto pixel = see(corner.place_m);
  const auto along_x = see(corner.place_m + Vector2d(step_m, 0));
  const auto along_y = see(corner.place_m + Vector2d(0, step_m));
  if (!pixel || !along_x || !along_y) return std::nullopt;
  return ExpectedCorner{*pixel, (*along_x - *pixel) / kShare, (*along_y - *pixel) / kShare};
}

std::vector<SeenCorner> look_again(size_t camera_index, const geometry::Camera& camera, const cv::Mat& grey,
                                   const std::vector<ChartPattern>& patterns,
                                   const std::vector<UnknownChart>& charts, const std::vector<bool>& placed,
                                   const std::vector<SeenCorner>& known, double reach_px) {
  std::vector<SeenCorner> found;
  std::copy_if(known.begin(), known.end(), std::back_inserter(found),
               [&](const SeenCorner& seen) { return seen.camera == camera_index; });
  for (size_t chart = 0; chart < patterns.size(); ++chart) {
    for (size_t k = 0; placed[chart] && k < patterns[chart].corners.size(); ++k) {
      if (find(known, camera_index, chart, static_cast<int>(k))) continue;
      const ChartCorner& corner = patterns[chart].corners[k];
      const auto expected = expect(camera, corner, charts[chart].vehicle_from_chart);
      if (!expected || !expected->can_be_found()) continue;
      const auto fitted = fit_corner(
          grey, *camera.lens, {expected->pixel, expected->along_x_px, expected->along_y_px, corner.dark});
      const double most_px = std::min(reach_px, kNear * expected->least_edge_px() + 0.5);
      if (!fitted || (fitted->pixel - expected->pixel).norm() > most_px) continue;
      found.push_back(
          {camera_index, chart, static_cast<int>(k), fitted->pixel, fitted->covariance_px2, false, false});
    }
  }
  return found;
}

}  // namespace svchain::calibration
