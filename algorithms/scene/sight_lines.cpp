#include "algorithms/scene/sight_lines.h"

#include <algorithm>
#include <cmath>

#include "algorithms/scene/motion.h"

namespace svchain::scene {

namespace {

constexpr int kMostTapsLog2 =
    1;  // four taps would mend little but the far distance, and cost a quarter of the speed

using Ray = Eigen::Vector3d;  // unit, in the vehicle's frame; zero where the lens does not reach

std::vector<Ray> rays_of_row(const geometry::Camera& camera, int y) {
  std::vector<Ray> rays(static_cast<size_t>(camera.image_size_px.x()), Ray::Zero());
  const Eigen::Matrix3d rotation = camera.vehicle_from_camera.rotation.toRotationMatrix();
  for (size_t x = 0; x < rays.size(); ++x) {
    if (const auto ray = camera.lens->unproject({static_cast<double>(x), static_cast<double>(y)}))
      rays[x] = rotation * *ray;
  }
  return rays;
}

/// Angle between two neighbours' rays, `usual` where one of them is missing.
double angle_between(const Ray& a, const Ray& b, double usual) {
  return a.isZero() || b.isZero() ? usual : (a - b).norm();
}

struct Aim {
  uint8_t target = Span::kNothing;
  uint8_t taps_log2 = 0;
  float x = 0, y = 0, stretch = 0;
};

/// `pixel_rad`: the angle that a pixel covers.
Aim aim(const World& world, const geometry::Camera& camera, const Ray& ray, double pixel_rad) {
  const Eigen::Vector3d& eye = camera.vehicle_from_camera.translation;
  if (ray.z() < 0) {
    const double range = -eye.z() / ray.z();
    const Eigen::Vector3d place = eye + range * ray;
    const double across = range * pixel_rad;
    const double along = across / -ray.z();
    const double resolved = std::max(across, world.ground().front().metres_per_texel);
    const int taps_log2 =
        std::clamp(static_cast<int>(std::lround(std::log2(along / resolved))), 0, kMostTapsLog2);
    const double tap = std::ldexp(along, -taps_log2);
    const double farthest = place.head<2>().norm() + largest_travel_m(world.scene().path) + along;
    if (const auto level = world.level_for(std::sqrt(across * tap), farthest)) {
      const double scale = 1 / world.ground()[*level].metres_per_texel;
      const double from_foot = (place - eye).head<2>().norm();
      return {static_cast<uint8_t>(*level), static_cast<uint8_t>(taps_log2),
              static_cast<float>(place.x() * scale), static_cast<float>(place.y() * scale),
              static_cast<float>(taps_log2 == 0 ? 0 : tap / from_foot)};
    }
  }
  const Panorama& panorama = world.panorama();
  const double elevation = std::atan2(ray.z(), std::hypot(ray.x(), ray.y())) / panorama.radians_per_texel;
  const double row = std::clamp(panorama.horizon_row - elevation, 0.0, panorama.texture.height - 2.0);
  return {
      Span::kPanorama, 0,
      static_cast<float>(panorama.first_column + std::atan2(ray.y(), ray.x()) / panorama.radians_per_texel),
      static_cast<float>(row), 0};
}

uint16_t falloff_at(const Response& response, const Eigen::Vector2d& from_centre_px, int width_px) {
  const double q2 = from_centre_px.squaredNorm() / (0.25 * width_px * width_px);
  return static_cast<uint16_t>(
      std::lround(65535 / (1 + response.falloff[0] * q2 + response.falloff[1] * q2 * q2)));
}

}  // namespace

std::vector<uint16_t> falloff_by_pixel(const Scene& scene, size_t index) {
  const geometry::Camera& camera = scene.rig.cameras[index];
  const int width = camera.image_size_px.x();
  const int height = camera.image_size_px.y();
  const Eigen::Vector2d centre =
      camera.lens->project({0, 0, 1}).value_or(Eigen::Vector2d(width / 2.0, height / 2.0));
  std::vector<uint16_t> falloff;
  falloff.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      falloff.push_back(falloff_at(scene.responses[index], Eigen::Vector2d(x, y) - centre, width));
  }
  return falloff;
}

SightLines trace_sight_lines(const World& world, size_t index) {
  const geometry::Camera& camera = world.scene().rig.cameras[index];
  SightLines lines;
  lines.width = camera.image_size_px.x();
  lines.height = camera.image_size_px.y();
  lines.foot_x_m = camera.vehicle_from_camera.translation.x();
  lines.foot_y_m = camera.vehicle_from_camera.translation.y();
  const size_t pixels = static_cast<size_t>(lines.width) * static_cast<size_t>(lines.height);
  lines.x.resize(pixels);
  lines.y.resize(pixels);
  lines.stretch.resize(pixels);
  lines.falloff = falloff_by_pixel(world.scene(), index);

  std::vector<Ray> row = rays_of_row(camera, 0);
  size_t pixel = 0;
  for (int y = 0; y < lines.height; ++y) {
    std::vector<Ray> below = rays_of_row(camera, y + 1);
    lines.first_span.push_back(lines.spans.size());
    for (int x = 0; x < lines.width; ++x, ++pixel) {
      const Ray& ray = row[static_cast<size_t>(x)];
      Aim a;
      if (!ray.isZero()) {
        const double right = x + 1 < lines.width ? angle_between(ray, row[static_cast<size_t>(x + 1)], 0) : 0;
        const double down = angle_between(ray, below[static_cast<size_t>(x)], right);
        a = aim(world, camera, ray, right > 0 ? std::sqrt(right * down) : down);
      }
      lines.x[pixel] = a.x;
      lines.y[pixel] = a.y;
      lines.stretch[pixel] = a.stretch;
      const bool same =
          x > 0 && lines.spans.back().target == a.target && lines.spans.back().taps_log2 == a.taps_log2;
      if (!same) lines.spans.push_back({static_cast<uint16_t>(x), 0, a.target, a.taps_log2});
      ++lines.spans.back().count;
    }
    row = std::move(below);
  }
  lines.first_span.push_back(lines.spans.size());
  return lines;
}

}  // namespace svchain::scene
