#include "algorithms/calibration/camera_pose.h"

#include <array>
#include <random>

#include "algorithms/geometry/homography_from_rays.h"
#include "algorithms/geometry/pose_from_homography.h"

namespace svchain::calibration {

namespace {

using geometry::GroundRay;
using geometry::Rigid3;
using geometry::Sighting;

constexpr int kRounds = 100;
constexpr double kAgreePx = 3;           // of a pose from four corners
constexpr double kAgreeRefinedPx = 2.5;  // of one from all that agree: a carpet's folds are no mistakes

std::vector<bool> agreeing(const geometry::Lens& lens, const std::vector<Sighting>& sightings,
                           const Rigid3& pose, double agree_px) {
  const Rigid3 camera_from_vehicle = pose.inverse();
  std::vector<bool> agrees;
  for (const auto& sighting : sightings) {
    const auto pixel = lens.project(camera_from_vehicle * sighting.point_in_vehicle);
    agrees.push_back(pixel && (*pixel - sighting.pixel).norm() < agree_px);
  }
  return agrees;
}

auto count(const std::vector<bool>& agrees) {
  return std::count(agrees.begin(), agrees.end(), true);
}

std::optional<Rigid3> pose_of(const std::vector<GroundRay>& pairs) {
  const auto homography = geometry::homography_from_rays(pairs);
  return homography ? geometry::pose_from_homography(*homography) : std::nullopt;
}

}  // namespace

std::optional<AgreedPose> agreed_pose(const geometry::Lens& lens, const std::vector<Sighting>& sightings) {
  std::vector<GroundRay> pairs;
  for (const auto& sighting : sightings) {
    const auto ray = lens.unproject(sighting.pixel);
    if (ray) pairs.push_back({sighting.point_in_vehicle.head<2>(), *ray});
  }
  if (pairs.size() < 4) return std::nullopt;

  AgreedPose best;
  const auto consider = [&](const std::optional<Rigid3>& pose) {
    if (!pose) return;
    auto agrees = agreeing(lens, sightings, *pose, kAgreePx);
    if (count(agrees) > count(best.agrees)) best = {*pose, std::move(agrees)};
  };
  std::mt19937 random(1);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<GroundRay> four;
    std::sample(pairs.begin(), pairs.end(), std::back_inserter(four), 4, random);
    consider(pose_of(four));
  }
  consider(pose_of(pairs));
  for (int round = 0; round < 3 && count(best.agrees) >= 4; ++round) {
    std::vector<Sighting> agreed;
    for (size_t i = 0; i < sightings.size(); ++i) {
      if (best.agrees[i]) agreed.push_back(sightings[i]);
    }
    best.vehicle_from_camera =
        geometry::refine_pose(lens, agreed, best.vehicle_from_camera).vehicle_from_camera;
    best.agrees = agreeing(lens, sightings, best.vehicle_from_camera, kAgreeRefinedPx);
  }
  if (count(best.agrees) < 4) return std::nullopt;
  return best;
}

}  // namespace svchain::calibration
