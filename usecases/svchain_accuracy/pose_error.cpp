#include "usecases/svchain_accuracy/pose_error.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/accuracy.h"
#include "algorithms/calibration/levelling.h"
#include "algorithms/geometry/angles.h"

namespace svchain::accuracy {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::Camera;
using geometry::Rig;

constexpr double kBesideM = 3;  // on a car
constexpr double kApartM = 0.1;

/// How far from the vehicle's rectangle; 0 on it.
double beside(const geometry::Vehicle& vehicle, const Vector2d& place) {
  return Vector2d(std::max(0.0, std::abs(place.x()) - vehicle.length_m / 2),
                  std::max(0.0, std::abs(place.y()) - vehicle.width_m / 2))
      .norm();
}

/// A place on the ground and the pixel at which a true camera sees it.
struct SeenPlace {
  Vector2d place_m;
  Vector2d pixel;
};

std::vector<SeenPlace> seen_places(const Rig& truth, size_t camera) {
  const double scale = calibration::scale_of(truth.vehicle);
  const double beside_m = scale * kBesideM, apart_m = scale * kApartM;
  const double end_x = truth.vehicle.length_m / 2 + beside_m, end_y = truth.vehicle.width_m / 2 + beside_m;
  std::vector<SeenPlace> places;
  for (double x = -end_x; x <= end_x; x += apart_m) {
    for (double y = -end_y; y <= end_y; y += apart_m) {
      const double away_m = beside(truth.vehicle, {x, y});
      if (away_m <= 0 || away_m > beside_m) continue;
      if (const auto pixel = truth.cameras[camera].see({x, y, 0})) places.push_back({{x, y}, *pixel});
    }
  }
  return places;
}

GroundOfPixel ground_by(const Camera& camera) {
  return [&camera](const Vector2d& pixel) {
    return calibration::ground_of(*camera.lens, camera.vehicle_from_camera, pixel);
  };
}

Vector3d turn_deg(const geometry::Rigid3& from, const geometry::Rigid3& to) {
  const Eigen::AngleAxisd turn(to.rotation * from.rotation.conjugate());
  return geometry::degrees(turn.angle()) * turn.axis();
}

Vector3d shift_mm(const geometry::Rigid3& from, const geometry::Rigid3& to) {
  return 1000 * (to.translation - from.translation);
}

}  // namespace

PoseError worst_of(const std::vector<PoseError>& errors) {
  PoseError worst;
  for (const auto& error : errors) {
    worst.rotation_deg = std::max(worst.rotation_deg, error.rotation_deg);
    worst.translation_mm = std::max(worst.translation_mm, error.translation_mm);
    worst.ground_mm = std::max(worst.ground_mm, error.ground_mm);
    worst.sigmas = std::max(worst.sigmas, error.sigmas);
  }
  return worst;
}

double ground_rms_mm(const Rig& truth, size_t camera, const GroundOfPixel& ground_of_pixel) {
  double sum = 0, count = 0;
  for (const auto& seen : seen_places(truth, camera)) {
    const auto ground = ground_of_pixel(seen.pixel);
    if (!ground) continue;
    sum += (*ground - seen.place_m).squaredNorm();
    ++count;
  }
  return 1000 * std::sqrt(sum / count);
}

std::vector<PoseError> pose_errors(const Rig& truth, const Rig& calibrated) {
  std::vector<PoseError> errors;
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    const auto& from = truth.cameras[c].vehicle_from_camera;
    const auto& to = calibrated.cameras[c].vehicle_from_camera;
    errors.push_back({turn_deg(from, to).norm(), shift_mm(from, to).norm(),
                      ground_rms_mm(truth, c, ground_by(calibrated.cameras[c])), 0});
  }
  return errors;
}

std::vector<PoseError> pose_errors(const Rig& truth, const Rig& calibrated,
                                   const std::vector<calibration::CameraAccuracy>& stated) {
  std::vector<PoseError> errors = pose_errors(truth, calibrated);
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    const auto& from = truth.cameras[c].vehicle_from_camera;
    const auto& to = calibrated.cameras[c].vehicle_from_camera;
    const Vector3d turn = turn_deg(from, to).cwiseQuotient(stated[c].sigma_rotation_deg);
    const Vector3d shift = shift_mm(from, to).cwiseQuotient(stated[c].sigma_translation_mm);
    errors[c].sigmas = std::max(turn.cwiseAbs().maxCoeff(), shift.cwiseAbs().maxCoeff());
  }
  return errors;
}

Rig in_best_place(const Rig& truth, Rig calibrated) {
  std::vector<Vector2d> from, to;
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    for (const auto& seen : seen_places(truth, c)) {
      const auto ground = ground_by(calibrated.cameras[c])(seen.pixel);
      if (!ground) continue;
      from.push_back(*ground);
      to.push_back(seen.place_m);
    }
  }
  const geometry::Pose2 motion = calibration::pose_between(from, to);
  const geometry::Rigid3 in_space{Eigen::Quaterniond(Eigen::AngleAxisd(motion.yaw_rad, Vector3d::UnitZ())),
                                  {motion.x_m, motion.y_m, 0}};
  for (auto& camera : calibrated.cameras) camera.vehicle_from_camera = in_space * camera.vehicle_from_camera;
  return calibrated;
}

}  // namespace svchain::accuracy
