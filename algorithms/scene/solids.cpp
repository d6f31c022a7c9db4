#include "algorithms/scene/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace svchain::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Where a ray first meets a surface, and which way that faces.
struct Meeting {
  double range_m = std::numeric_limits<double>::infinity();
  Vector3d normal = Vector3d::Zero();
};

/// The ray enters the box where it has entered all three pairs of planes (Kay and Kajiya 1986).
Meeting meet(const Box& box, const Turn& turn, const Vector3d& eye, const Vector3d& ray) {
  const Pose2& pose = box.world_from_box;
  const Vector3d from = turn.back(eye - Vector3d(pose.x_m, pose.y_m, box.size_m.z() / 2));
  const Vector3d along = turn.back(ray);
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  Vector3d normal = Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double half = box.size_m[axis] / 2;
    if (along[axis] == 0) {
      if (std::abs(from[axis]) > half) return {};
      continue;
    }
    const double side = along[axis] > 0 ? 1 : -1;
    const double in = (-side * half - from[axis]) / along[axis];
    leave = std::min(leave, (side * half - from[axis]) / along[axis]);
    if (in <= enter) continue;
    enter = in;
    normal = -side * Vector3d::Unit(axis);
  }
  if (enter == 0 || enter > leave) return {};
  return {enter, turn * normal};
}

Meeting meet(const Post& post, const Vector3d& eye, const Vector3d& ray) {
  const Vector2d from = eye.head<2>() - post.place_m;
  const Vector2d along = ray.head<2>();
  if (ray.z() < 0 && eye.z() > post.height_m) {
    const double range = (post.height_m - eye.z()) / ray.z();
    if ((from + range * along).norm() <= post.radius_m) return {range, Vector3d::UnitZ()};
  }
  const double a = along.squaredNorm();
  const double b = from.dot(along);
  const double root = b * b - a * (from.squaredNorm() - post.radius_m * post.radius_m);
  if (a == 0 || root < 0) return {};
  const double range = (-b - std::sqrt(root)) / a;
  const double height = eye.z() + range * ray.z();
  if (range <= 0 || height < 0 || height > post.height_m) return {};
  const Vector2d outward = (from + range * along) / post.radius_m;
  return {range, {outward.x(), outward.y(), 0}};
}

/// A high sun to the front left, under a bright sky.
Vector3d lit(Colour colour, const Vector3d& normal) {
  static const Vector3d kSun = Vector3d(0.4, 0.3, 0.87).normalized();
  const double light = 0.7 + 0.3 * std::max(0.0, normal.dot(kSun));
  return light * Vector3d(colour.b, colour.g, colour.r);
}

bool comes_near(const Sphere& sphere, const Vector3d& eye, const Vector3d& ray) {
  const Vector3d to = sphere.centre_m - eye;
  const double ahead = to.dot(ray);
  return ahead > -sphere.radius_m && to.squaredNorm() - ahead * ahead <= sphere.radius_m * sphere.radius_m;
}

}  // namespace

Solids::Solids(const Scene& scene) : boxes_(scene.boxes), posts_(scene.posts) {
  for (const Box& box : boxes_) {
    const Pose2& pose = box.world_from_box;
    turns_.emplace_back(pose.yaw_rad);
    spheres_.push_back({{pose.x_m, pose.y_m, box.size_m.z() / 2}, box.size_m.norm() / 2});
  }
  for (const Post& post : posts_) {
    spheres_.push_back({{post.place_m.x(), post.place_m.y(), post.height_m / 2},
                        std::hypot(post.height_m / 2, post.radius_m)});
  }
}

std::optional<Vector3d> Solids::first_seen(const Vector3d& eye, const Vector3d& ray) const {
  Meeting nearest;
  Colour colour;
  for (size_t i = 0; i < spheres_.size(); ++i) {
    if (!comes_near(spheres_[i], eye, ray)) continue;
    const bool box = i < boxes_.size();
    const size_t post = i - boxes_.size();
    const Meeting meeting = box ? meet(boxes_[i], turns_[i], eye, ray) : meet(posts_[post], eye, ray);
    if (meeting.range_m >= nearest.range_m) continue;
    nearest = meeting;
    colour = box ? boxes_[i].colour : posts_[post].colour;
  }
  if (std::isinf(nearest.range_m)) return std::nullopt;
  return lit(colour, nearest.normal);
}

}  // namespace svchain::scene
