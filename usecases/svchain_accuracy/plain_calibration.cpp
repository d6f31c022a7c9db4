#include "usecases/svchain_accuracy/plain_calibration.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/refine_pose.h"

namespace svchain::accuracy {

namespace {

using Eigen::Vector2d;

constexpr double kIdealRad = geometry::radians(80);
constexpr double kBorderPx = 8;  // as much as cornerSubPix needs around a corner

/// The pixel on an ideal pinhole's picture of focal length 1.
std::optional<Vector2d> ideal_of(const geometry::Lens& lens, const Vector2d& pixel) {
  const auto ray = lens.unproject(pixel);
  if (!ray || ray->z() < std::cos(kIdealRad)) return std::nullopt;
  return Vector2d(ray->hnormalized());
}

bool well_inside(const geometry::Camera& camera, const Vector2d& pixel) {
  const Vector2d last = camera.image_size_px.cast<double>().array() - 1 - kBorderPx;
  return (pixel.array() >= kBorderPx).all() && (pixel.array() <= last.array()).all();
}

/// Half a window such that no other corner is in it.
int half_window_px(const std::vector<PlainCorner>& corners, size_t which) {
  double nearest_px = 1e9;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (i != which) nearest_px = std::min(nearest_px, (corners[i].pixel - corners[which].pixel).norm());
  }
  return std::clamp(static_cast<int>(0.4 * nearest_px), 2, 5);
}

Vector2d found_near(const cv::Mat& grey, const Vector2d& start, int half_px) {
  const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 0.001);
  std::vector<cv::Point2f> found = {
      {static_cast<float>(std::round(start.x())), static_cast<float>(std::round(start.y()))}};
  cv::cornerSubPix(grey, found, {half_px, half_px}, {-1, -1}, enough);
  return {found[0].x, found[0].y};
}

}  // namespace

std::vector<std::vector<PlainCorner>> plain_corners(const geometry::Rig& truth,
                                                    const std::vector<calibration::Chart>& charts,
                                                    const std::vector<cv::Mat>& pictures) {
  std::vector<std::vector<PlainCorner>> all(truth.cameras.size());
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    std::vector<PlainCorner> seen;
    for (const auto& chart : charts) {
      for (const auto& corner : calibration::corners(chart)) {
        const Vector2d ground = chart.vehicle_from_chart.value() * corner.place_m;
        const auto pixel = truth.cameras[c].see({ground.x(), ground.y(), 0});
        if (pixel && well_inside(truth.cameras[c], *pixel)) seen.push_back({ground, *pixel});
      }
    }
    cv::Mat grey;
    cv::cvtColor(pictures[c], grey, cv::COLOR_BGR2GRAY);
    for (size_t i = 0; i < seen.size(); ++i)
      all[c].push_back({seen[i].ground_m, found_near(grey, seen[i].pixel, half_window_px(seen, i))});
  }
  return all;
}

geometry::Rig poses_refined(geometry::Rig nominal, const std::vector<std::vector<PlainCorner>>& corners) {
  for (size_t c = 0; c < nominal.cameras.size(); ++c) {
    std::vector<geometry::Sighting> sightings;
    for (const auto& corner : corners[c])
      sightings.push_back({{corner.ground_m.x(), corner.ground_m.y(), 0}, corner.pixel});
    auto& camera = nominal.cameras[c];
    camera.vehicle_from_camera =
        refine_pose(*camera.lens, sightings, camera.vehicle_from_camera).vehicle_from_camera;
  }
  return nominal;
}

PlainHomography::PlainHomography(geometry::LensPtr lens, const std::vector<PlainCorner>& corners)
    : lens_(std::move(lens)) {
  std::vector<cv::Point2d> ideal, ground;
  for (const auto& corner : corners) {
    const auto place = ideal_of(*lens_, corner.pixel);
    if (!place) continue;
    ideal.emplace_back(place->x(), place->y());
    ground.emplace_back(corner.ground_m.x(), corner.ground_m.y());
  }
  cv::Mat found;
  if (ideal.size() >= 4) found = cv::findHomography(ideal, ground);
  if (found.empty()) found = cv::Mat::zeros(3, 3, CV_64F);
  for (int i = 0; i < 9; ++i) ground_from_ideal_(i / 3, i % 3) = found.at<double>(i / 3, i % 3);
}

std::optional<Vector2d> PlainHomography::ground_of(const Vector2d& pixel) const {
  const auto ideal = ideal_of(*lens_, pixel);
  if (!ideal) return std::nullopt;
  return Vector2d((ground_from_ideal_ * ideal->homogeneous()).hnormalized());
}

}  // namespace svchain::accuracy
