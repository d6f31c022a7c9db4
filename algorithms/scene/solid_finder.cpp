#include "algorithms/scene/solid_finder.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scene/sensor.h"

namespace svchain::scene {

namespace {

constexpr size_t kRun = 32;  // pixels

}  // namespace

SolidFinder::SolidFinder(const Scene& scene, size_t index)
    : solids_(scene), eye_in_vehicle_(scene.rig.cameras[index].vehicle_from_camera.translation) {
  if (solids_.spheres().empty()) return;
  const geometry::Camera& camera = scene.rig.cameras[index];
  for (int y = 0; y < camera.image_size_px.y(); ++y) {
    for (int x = 0; x < camera.image_size_px.x(); ++x) {
      const auto ray = camera.lens->unproject({static_cast<double>(x), static_cast<double>(y)});
      const Eigen::Vector3d turned =
          camera.vehicle_from_camera.rotation * ray.value_or(Eigen::Vector3d::Zero());
      rays_.emplace_back(turned.cast<float>());
    }
  }
  for (size_t first = 0; first < rays_.size(); first += kRun) {
    const size_t end = std::min(first + kRun, rays_.size());
    Run run{Eigen::Vector3f::Zero(), 1, 0};
    for (size_t i = first; i < end; ++i) run.axis += rays_[i];
    if (!run.axis.isZero()) run.axis.normalize();
    for (size_t i = first; i < end; ++i) {
      if (!rays_[i].isZero()) run.cos_half = std::min(run.cos_half, run.axis.dot(rays_[i]));
    }
    run.sin_half = std::sqrt(std::max(0.0f, 1 - run.cos_half * run.cos_half));
    runs_.push_back(run);
  }
}

/// A cone and a sphere meet where the angle between them is at most the sum of their half angles. Runs wider
/// than a right angle (the end of a row and the beginning of the next) are looked at always.
bool SolidFinder::may_hit(const Run& run, const Turn& turn, const Eigen::Vector3d& eye) const {
  if (run.axis.isZero()) return false;
  if (run.cos_half <= 0) return true;
  const Eigen::Vector3d axis = turn * run.axis.cast<double>();
  return std::any_of(solids_.spheres().begin(), solids_.spheres().end(), [&](const Sphere& sphere) {
    const Eigen::Vector3d to = sphere.centre_m - eye;
    const double distance = to.norm();
    if (distance <= sphere.radius_m) return true;
    const double sin_sphere = sphere.radius_m / distance;
    const double cos_sphere = std::sqrt(1 - sin_sphere * sin_sphere);
    const double least = cos_sphere * run.cos_half - sin_sphere * run.sin_half;
    return axis.dot(to) >= (least - 1e-5) * distance;
  });
}

void SolidFinder::cover(const Pose2& pose, size_t first, size_t count, uint64_t* light) const {
  if (rays_.empty()) return;
  const Eigen::Vector2d foot = pose * eye_in_vehicle_.head<2>();
  const Eigen::Vector3d eye(foot.x(), foot.y(), eye_in_vehicle_.z());
  const Turn turn(pose.yaw_rad);
  for (size_t pixel = first; pixel < first + count;) {
    const size_t end = std::min(first + count, (pixel / kRun + 1) * kRun);
    if (!may_hit(runs_[pixel / kRun], turn, eye)) {
      pixel = end;
      continue;
    }
    for (; pixel < end; ++pixel) {
      if (rays_[pixel].isZero()) continue;
      const auto seen = solids_.first_seen(eye, turn * rays_[pixel].cast<double>());
      if (seen) light[pixel - first] = packed_light(*seen);
    }
  }
}

}  // namespace svchain::scene
