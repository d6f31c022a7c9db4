#include "algorithms/geometry/mapped_ground.h"

#include <Eigen/LU>

#include "algorithms/geometry/pose_from_homography.h"
#include "algorithms/geometry/refine_pose.h"

namespace svchain::geometry {

namespace {

/// Direction in which a camera of this name looks.
Eigen::Vector3d outward(const std::string& name) {
  if (name == "front") return {1, 0, 0};
  if (name == "right") return {0, -1, 0};
  if (name == "rear") return {-1, 0, 0};
  return {0, 1, 0};
}

std::vector<Sighting> sightings_of(const MappedGround& map, const Camera& camera) {
  constexpr double kStepM = 0.1;
  std::vector<Sighting> sightings;
  const Eigen::Vector2d from = map.shown_m().min();
  const Eigen::Vector2d to = map.shown_m().max();
  for (double x = from.x(); x <= to.x(); x += kStepM) {
    for (double y = from.y(); y <= to.y(); y += kStepM) {
      if (const auto pixel = map.see({x, y}, camera)) sightings.push_back({{x, y, 0}, *pixel});
    }
  }
  return sightings;
}

}  // namespace

MappedGround::MappedGround(const Eigen::Matrix3d& ideal_from_ground, const Eigen::Matrix3d& ideal_from_ray,
                           Eigen::Vector2i ideal_size_px, const Eigen::AlignedBox2d& shown_m)
    : ray_from_ground_(ideal_from_ray.inverse() * ideal_from_ground),
      ideal_from_ray_(ideal_from_ray),
      ideal_size_px_(ideal_size_px),
      shown_m_(shown_m) {
  const Eigen::Vector2d middle = shown_m_.center();
  if ((ray_from_ground_ * middle.homogeneous()).z() < 0) ray_from_ground_ *= -1;
}

std::optional<Eigen::Vector2d> MappedGround::see(const Eigen::Vector2d& ground, const Camera& camera) const {
  const Eigen::Vector3d ray = ray_from_ground_ * ground.homogeneous();
  if (!(ray.z() > 0)) return std::nullopt;
  const Eigen::Array2d ideal = (ideal_from_ray_ * ray).hnormalized();
  if ((ideal < 0).any() || (ideal > ideal_size_px_.cast<double>().array() - 1).any()) return std::nullopt;
  const auto pixel = camera.lens->project(ray);
  if (!pixel || !camera.contains(*pixel)) return std::nullopt;
  return pixel;
}

Result<double> pose_camera(const MappedGround& map, const std::string& file, Camera& camera) {
  const auto first = pose_from_homography(map.ray_from_ground());
  if (!first) return fail(file, "the homography is singular, expected one that shows the ground");
  constexpr size_t kFewestSightings = 50;
  const auto sightings = sightings_of(map, camera);
  if (sightings.size() < kFewestSightings) {
    return fail(
        file, "the homography shows next to nothing of the ground in the " + camera.name + " camera's image");
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& sighting : sightings) middle += sighting.point_in_vehicle;
  middle /= static_cast<double>(sightings.size());
  if (!((first->inverse() * middle).z() > 0)) {
    return fail(file, "the homography shows the ground mirrored or from below");
  }
  const auto refined = refine_pose(*camera.lens, sightings, *first);
  camera.vehicle_from_camera = refined.vehicle_from_camera;
  const Eigen::Vector3d axis = camera.vehicle_from_camera.rotation * Eigen::Vector3d::UnitZ();
  if (!(axis.dot(outward(camera.name)) > 0)) {
    return fail(file, "the " + camera.name + " camera would look inwards, is this another camera's file?");
  }
  return refined.rms_px;
}

}  // namespace svchain::geometry
