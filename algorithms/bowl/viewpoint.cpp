#include "algorithms/bowl/viewpoint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "algorithms/geometry/angles.h"

namespace svchain::bowl {
namespace {

constexpr double kBodyHeight = 0.35;   // of the length
constexpr double kLeastUpSine = 0.01;  // of the angle between up and the sight
constexpr double kLeastSightM = 1e-6;

std::string text(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text << v.x() << ", " << v.y() << ", " << v.z();
  return text.str();
}

/// Below this an eye is below the bowl; beyond the rim that is the rim.
double ground_below(const BowlSurface& surface, const Eigen::Vector3d& eye) {
  const double height = surface.height_at(eye.head<2>());
  return std::min(height, surface.height_m);
}

void check_eye(const Viewpoint& viewpoint, const geometry::Vehicle& vehicle, const BowlSurface& surface,
               Faults& faults) {
  const std::string eye = "the eye at " + text(viewpoint.eye_m) + " m is ";
  const double ground = ground_below(surface, viewpoint.eye_m);
  if (!(viewpoint.eye_m.z() > ground)) {
    const std::string what = ground > 0 ? "below the bowl" : "not above the ground";
    faults.push_back({{}, {}, "/eye_m", eye + what + ", expected it above " + std::to_string(ground) + " m"});
  } else if (is_in_body(vehicle, viewpoint.eye_m)) {
    faults.push_back({{},
                      {},
                      "/eye_m",
                      eye + "inside the vehicle, expected it outside its box of " +
                          std::to_string(vehicle.length_m) + " x " + std::to_string(vehicle.width_m) + " x " +
                          std::to_string(body_height_m(vehicle)) + " m"});
  }
}

}  // namespace

Perspective::Perspective(const Viewpoint& viewpoint, const Eigen::Vector2i& size_px) : eye_(viewpoint.eye_m) {
  axes_.col(2) = (viewpoint.target_m - viewpoint.eye_m).normalized();
  axes_.col(0) = axes_.col(2).cross(viewpoint.up).normalized();
  axes_.col(1) = axes_.col(2).cross(axes_.col(0));
  centre_ = (size_px.cast<double>() - Eigen::Vector2d::Ones()) / 2;
  focal_px_ = size_px.y() / (2 * std::tan(geometry::radians(viewpoint.field_of_view_deg) / 2));
}

std::optional<Eigen::Vector2d> Perspective::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = axes_.transpose() * (point - eye_);
  if (!(p.z() > 0)) return std::nullopt;
  return centre_ + focal_px_ * p.head<2>() / p.z();
}

double body_height_m(const geometry::Vehicle& vehicle) {
  return kBodyHeight * vehicle.length_m;
}

bool is_in_body(const geometry::Vehicle& vehicle, const Eigen::Vector3d& point) {
  return std::abs(point.x()) <= vehicle.length_m / 2 && std::abs(point.y()) <= vehicle.width_m / 2 &&
         point.z() <= body_height_m(vehicle);
}

Faults check(const Viewpoint& viewpoint, const geometry::Vehicle& vehicle, const BowlSurface& surface) {
  Faults faults;
  const auto finite = [&](const char* pointer, const Eigen::Vector3d& v) {
    if (!v.allFinite()) faults.push_back({{}, {}, pointer, "expected three numbers, got " + text(v)});
    return v.allFinite();
  };
  const bool eye = finite("/eye_m", viewpoint.eye_m);
  const bool target = finite("/target_m", viewpoint.target_m);
  const bool up = finite("/up", viewpoint.up);
  if (eye) check_eye(viewpoint, vehicle, surface, faults);

  const Eigen::Vector3d sight = viewpoint.target_m - viewpoint.eye_m;
  const bool looks = eye && target && sight.norm() > kLeastSightM;
  if (eye && target && !looks)
    faults.push_back({{}, {}, "/target_m", "is where the eye is, expected a point to look at"});
  if (up && !(viewpoint.up.norm() > 0)) {
    faults.push_back({{}, {}, "/up", "has no direction, expected one, such as 0, 0, 1"});
  } else if (up && looks &&
             sight.cross(viewpoint.up).norm() < kLeastUpSine * sight.norm() * viewpoint.up.norm()) {
    faults.push_back({{},
                      {},
                      "/up",
                      "points along the sight, expected it across, such as 1, 0, 0 for a look "
                      "straight down"});
  }
  if (!(viewpoint.field_of_view_deg >= 1 && viewpoint.field_of_view_deg <= 150)) {
    faults.push_back({{},
                      {},
                      "/field_of_view_deg",
                      "expected 1 to 150 degrees, got " + std::to_string(viewpoint.field_of_view_deg)});
  }
  return faults;
}

}  // namespace svchain::bowl
