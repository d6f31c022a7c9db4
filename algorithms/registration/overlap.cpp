#include "algorithms/registration/overlap.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/synthesis/own_body.h"

namespace svchain::registration {

namespace {

constexpr double kBorderPx = 2;                       // of the image
constexpr double kRimRad = geometry::radians(10);     // inside the lens's largest angle
constexpr double kWidestRad = geometry::radians(82);  // beyond, housings stand in the picture
constexpr int kCellPx = 4;                            // of what both see

bool on_vehicle(const geometry::Vehicle& vehicle, const Eigen::Vector2d& ground) {
  return std::abs(ground.x()) < vehicle.length_m / 2 && std::abs(ground.y()) < vehicle.width_m / 2;
}

}  // namespace

GroundSight::GroundSight(const GroundCamera& camera, const geometry::Vehicle& vehicle)
    : camera_(camera),
      vehicle_(vehicle),
      cos_widest_(std::cos(std::min(kWidestRad, camera.lens->max_angle_rad() - kRimRad))) {
  // The vertical is what is across both of the ground's axes; the camera is where all rays begin.
  const Eigen::Matrix3d& m = camera.ray_from_ground;
  Eigen::Matrix3d camera_from_vehicle;
  camera_from_vehicle << m.leftCols<2>(), m.col(0).cross(m.col(1));
  position_ = -(camera_from_vehicle.inverse() * m.col(2)).head<2>();
}

bool GroundSight::sees(const Eigen::Vector2d& ground) const {
  if (on_vehicle(vehicle_, ground)) return false;
  const Eigen::Vector3d ray = camera_.ray_from_ground * ground.homogeneous();
  if (ray.z() < cos_widest_ * ray.norm()) return false;
  const auto pixel = camera_.lens->project(ray);
  if (!pixel) return false;
  const Eigen::Vector2d last = camera_.image_size_px.cast<double>() - Eigen::Vector2d::Ones();
  if (std::min(pixel->minCoeff(), (last - *pixel).minCoeff()) < kBorderPx) return false;
  return synthesis::sight_past_body(vehicle_, position_, ground) == 1;
}

std::optional<geometry::View> overlap_of(const GroundSight& a, const GroundSight& b,
                                         const geometry::View& view, double metres_per_px) {
  constexpr int kStepPx = 8;
  Eigen::AlignedBox2d seen;
  for (int j = 0; j < view.size_px.y(); j += kStepPx) {
    for (int i = 0; i < view.size_px.x(); i += kStepPx) {
      const Eigen::Vector2d ground = view.ground_from_pixel(Eigen::Vector2d(i, j));
      if (a.sees(ground) && b.sees(ground)) seen.extend(ground);
    }
  }
  if (seen.isEmpty()) return std::nullopt;
  geometry::View overlap;
  overlap.metres_per_px = metres_per_px;
  overlap.centre_m = seen.center();
  overlap.size_px = {static_cast<int>(std::ceil(seen.sizes().y() / metres_per_px)) + 1,
                     static_cast<int>(std::ceil(seen.sizes().x() / metres_per_px)) + 1};
  return overlap;
}

cv::Mat seen_by_both(const GroundSight& a, const GroundSight& b, const geometry::View& view) {
  cv::Mat seen(view.size_px.y(), view.size_px.x(), CV_8U);
  for (int j = 0; j < seen.rows; j += kCellPx) {
    for (int i = 0; i < seen.cols; i += kCellPx) {
      const Eigen::Vector2d ground = view.ground_from_pixel(Eigen::Vector2d(i, j));
      const bool both = a.sees(ground) && b.sees(ground);
      seen(cv::Rect(i, j, kCellPx, kCellPx) & cv::Rect({0, 0}, seen.size())) = both ? 255 : 0;
    }
  }
  return seen;
}

}  // namespace svchain::registration
