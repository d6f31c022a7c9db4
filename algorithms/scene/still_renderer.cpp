#include "algorithms/scene/still_renderer.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scene/hash.h"
#include "algorithms/scene/motion.h"
#include "algorithms/scene/sight_lines.h"

namespace svchain::scene {

namespace {

constexpr int kRays = 4;  // each way in a pixel
constexpr double kBlurPx = 0.5;

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Between the corners of its pixel a ray is as good as linear.
struct Corners {
  Vector3d upper_left, upper_right, lower_left, lower_right;

  Vector3d at(double x, double y) const {
    return (1 - y) * ((1 - x) * upper_left + x * upper_right) + y * ((1 - x) * lower_left + x * lower_right);
  }
  bool seen() const {
    return !upper_left.isZero() && !upper_right.isZero() && !lower_left.isZero() && !lower_right.isZero();
  }
};

/// Rays of the corners between the pixels and around them; zero where the lens does not reach.
cv::Mat corner_rays(const geometry::Camera& camera) {
  cv::Mat rays(camera.image_size_px.y() + 1, camera.image_size_px.x() + 1, CV_32FC3, cv::Scalar::all(0));
  for (int y = 0; y < rays.rows; ++y) {
    for (int x = 0; x < rays.cols; ++x) {
      const auto ray = camera.lens->unproject({x - 0.5, y - 0.5});
      if (!ray) continue;
      const Vector3f turned = (camera.vehicle_from_camera.rotation * *ray).cast<float>();
      rays.at<cv::Vec3f>(y, x) = {turned.x(), turned.y(), turned.z()};
    }
  }
  return rays;
}

Corners corners_of(const cv::Mat& rays, int x, int y) {
  const auto at = [&](int i, int j) {
    const auto& ray = rays.at<cv::Vec3f>(j, i);
    return Vector3d(ray[0], ray[1], ray[2]);
  };
  return {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
}

/// One camera at one moment.
struct Look {
  const World& world;
  Pose2 pose;
  Vector3d eye;  // in the vehicle's frame
  const Solids& solids;
  Turn turn = Turn(pose.yaw_rad);

  Eigen::Vector2d ground_point(const Vector3d& ray) const {
    return pose * (eye - eye.z() / ray.z() * ray).head<2>();
  }

  /// What the rays of a pixel that meet the ground are to sample; nothing where that is too far away.
  const GroundLevel* level_of(const Corners& corners) const {
    const Vector3d ray = corners.at(0.5, 0.5);
    const double range = -eye.z() / ray.z();
    const double across = range * (corners.upper_right - corners.upper_left).norm();
    const double along = across / -ray.z();
    const double reach = ground_point(ray).norm() + along;
    const auto level = world.level_for(std::min(across, along / kRays), reach);
    return level ? &world.ground()[*level] : nullptr;
  }

  std::optional<Vector3d> solid_on(const Vector3d& ray) const {
    if (solids.spheres().empty()) return std::nullopt;
    const Eigen::Vector2d foot = pose * eye.head<2>();
    return solids.first_seen({foot.x(), foot.y(), eye.z()}, (turn * ray).normalized());
  }

  Vector3d surroundings(const Vector3d& ray) const {
    const Panorama& panorama = world.panorama();
    const double elevation = std::atan2(ray.z(), std::hypot(ray.x(), ray.y()));
    const double azimuth = std::atan2(ray.y(), ray.x()) + pose.yaw_rad;
    return sample(panorama.texture, panorama.first_column + azimuth / panorama.radians_per_texel,
                  panorama.horizon_row - elevation / panorama.radians_per_texel);
  }

  Vector3d light(const Corners& corners) const {
    const bool down = std::max({corners.upper_left.z(), corners.upper_right.z(), corners.lower_left.z(),
                                corners.lower_right.z()}) < 0;
    const GroundLevel* level = down ? level_of(corners) : nullptr;
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < kRays * kRays; ++k) {
      const Vector3d ray = corners.at((k % kRays + 0.5) / kRays, (k / kRays + 0.5) / kRays);
      if (const auto solid = solid_on(ray)) {
        sum += *solid;
      } else if (level) {
        const Eigen::Vector2d place = ground_point(ray);
        sum += sample(level->texture, level->texel_at(place.x()), level->texel_at(place.y()));
      } else {
        sum += surroundings(ray);
      }
    }
    return sum / (kRays * kRays);
  }
};

/// A Gaussian along one direction; two pixels away it is as good as nothing.
cv::Mat blurred(const cv::Mat& light, cv::Point step) {
  const float side = static_cast<float>(std::exp(-1 / (2 * kBlurPx * kBlurPx)));
  cv::Mat out(light.size(), light.type());
  const cv::Rect all({}, light.size());
  for (int y = 0; y < light.rows; ++y) {
    for (int x = 0; x < light.cols; ++x) {
      const cv::Point here(x, y);
      const auto at = [&](cv::Point p) { return light.at<cv::Vec3f>(all.contains(p) ? p : here); };
      out.at<cv::Vec3f>(here) =
          (at(here) + side * (at(here - step) + at(here + step))) * (1 / (1 + 2 * side));
    }
  }
  return out;
}

}  // namespace

StillRenderer::StillRenderer(std::shared_ptr<const World> world)
    : world_(std::move(world)), solids_(world_->scene()) {
  const Scene& scene = world_->scene();
  for (size_t camera = 0; camera < scene.rig.cameras.size(); ++camera) {
    rays_.push_back(corner_rays(scene.rig.cameras[camera]));
    falloffs_.push_back(falloff_by_pixel(scene, camera));
    sensors_.emplace_back(scene.responses[camera], hash(scene.seed, camera));
  }
}

cv::Mat StillRenderer::render(size_t camera, double time_s, uint64_t frame) const {
  const Scene& scene = world_->scene();
  const Look look{*world_, world_from_vehicle(scene.path, time_s),
                  scene.rig.cameras[camera].vehicle_from_camera.translation, solids_};
  const cv::Mat& rays = rays_[camera];
  cv::Mat light(rays.rows - 1, rays.cols - 1, CV_32FC3, cv::Scalar::all(0));
  cv::Mat bgr(light.size(), CV_8UC3);
  for (int y = 0; y < light.rows; ++y) {
    for (int x = 0; x < light.cols; ++x) {
      const Corners corners = corners_of(rays, x, y);
      if (!corners.seen()) continue;
      const Vector3f arrived = look.light(corners).cast<float>();
      light.at<cv::Vec3f>(y, x) = {arrived.x(), arrived.y(), arrived.z()};
    }
  }
  light = blurred(light, {1, 0});
  light = blurred(light, {0, 1});
  for (int y = 0; y < light.rows; ++y) {
    for (int x = 0; x < light.cols; ++x) {
      const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(light.cols) + static_cast<size_t>(x);
      auto& out = bgr.at<cv::Vec3b>(y, x);
      const auto& arrived = light.at<cv::Vec3f>(y, x);
      const uint64_t word = packed_light({arrived[0], arrived[1], arrived[2]});
      sensors_[camera].develop(&word, &falloffs_[camera][pixel], 1, hash(frame, pixel), out.val);
      if (!corners_of(rays, x, y).seen()) out = {};
    }
  }
  return bgr;
}

}  // namespace svchain::scene
