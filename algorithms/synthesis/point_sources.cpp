#include "algorithms/synthesis/point_sources.h"

#include <utility>

namespace svchain::synthesis {
namespace {

std::vector<RayFromPoint> rays_from_point(const geometry::Rig& rig) {
  std::vector<RayFromPoint> rays;
  for (const geometry::Camera& camera : rig.cameras) {
    const Eigen::Matrix3d turn = camera.vehicle_from_camera.rotation.toRotationMatrix().transpose();
    rays.emplace_back() << turn, -turn * camera.vehicle_from_camera.translation;
  }
  return rays;
}

PointSources one(int camera, const CameraReach::Seen& seen) {
  PointSources sources;
  sources.count = 1;
  sources.camera[0] = camera;
  sources.image_px[0] = seen.pixel;
  return sources;
}

}  // namespace

SourceFinder::SourceFinder(const geometry::Rig& rig, const std::vector<RayFromPoint>& ray_from_point,
                           const BlendShape& shape)
    : vehicle_(rig.vehicle), shape_(shape) {
  for (size_t i = 0; i < rig.cameras.size(); ++i)
    reaches_.emplace_back(rig.cameras[i], ray_from_point[i], rig.vehicle);
}

SourceFinder::SourceFinder(const geometry::Rig& rig, const BlendShape& shape)
    : SourceFinder(rig, rays_from_point(rig), shape) {}

PointSources SourceFinder::find(const Eigen::Vector3d& point) const {
  const CameraShares shares = camera_shares(vehicle_, shape_, point.head<2>());
  return shares.share_of_first >= 0.5 ? find(point, shares.first, shares.second, shares)
                                      : find(point, shares.second, shares.first, shares);
}

/// Projection is what this costs, so the lesser camera is asked only where it can matter.
PointSources SourceFinder::find(const Eigen::Vector3d& point, int main, int other,
                                const CameraShares& shares) const {
  const auto main_seen = reaches_[main].see(point);
  const bool alone = main == shares.first ? shares.share_of_first >= 1 : shares.share_of_first <= 0;
  if (alone && main_seen && main_seen->fade >= 1) return one(main, *main_seen);

  const auto other_seen = reaches_[other].see(point);
  const double main_fade = main_seen ? main_seen->fade : 0;
  const double other_fade = other_seen ? other_seen->fade : 0;
  if (main_fade <= 0 && other_fade <= 0) return {};

  const bool in_order = main == shares.first;
  const int weight = first_weight(shape_, shares.share_of_first, in_order ? main_fade : other_fade,
                                  in_order ? other_fade : main_fade);
  const int main_weight = in_order ? weight : 255 - weight;
  if (main_weight == 255) return one(main, *main_seen);
  if (main_weight == 0) return one(other, *other_seen);
  PointSources sources{2, {main, other}, {main_seen->pixel, other_seen->pixel}, shown_weight(shape_, weight)};
  if (!in_order) {
    std::swap(sources.camera[0], sources.camera[1]);
    std::swap(sources.image_px[0], sources.image_px[1]);
  }
  return sources;
}

PointSources SourceFinder::find_pair(const Eigen::Vector3d& point) const {
  const CameraShares shares = camera_shares(vehicle_, shape_, point.head<2>());
  const auto first = reaches_[shares.first].see(point), second = reaches_[shares.second].see(point);
  const double first_fade = first ? first->fade : 0, second_fade = second ? second->fade : 0;
  if (first_fade <= 0 && second_fade <= 0) return {};
  if (second_fade <= 0) return one(shares.first, *first);
  if (first_fade <= 0) return one(shares.second, *second);
  const int weight = first_weight(shape_, shares.share_of_first, first_fade, second_fade);
  return {2, {shares.first, shares.second}, {first->pixel, second->pixel}, shown_weight(shape_, weight)};
}

}  // namespace svchain::synthesis
