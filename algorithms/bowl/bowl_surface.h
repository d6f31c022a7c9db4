#pragma once
// The world around a vehicle as a bowl: a flat floor, and around it a wall that rises to a rim. With d the
// horizontal distance of a point from the floor (0 on it; Euclidean, so a rectangle's corners are round),
//   height = height_m (d / rise_m)^exponent,   0 <= d <= rise_m.
// d is convex because both floors are, and so is the height for an exponent of at least 1: a ray that is
// above the bowl leaves that region once, which is what makes intersect() short. docs/bowl.svg shows the
// parameters. Vehicle frame, metres. Plain value and plain functions, any thread, nothing allocated but by
// check().

#include <Eigen/Core>
#include <optional>

#include "algorithms/geometry/rig.h"
#include "algorithms/json/fault.h"

namespace svchain::bowl {

enum class FloorShape { kRectangle, kEllipse };

struct BowlSurface {
  FloorShape shape = FloorShape::kRectangle;
  double floor_length_m = 0;  // full extent along x
  double floor_width_m = 0;   // full extent along y
  double rise_m = 0;          // horizontal distance from the floor's edge to the rim
  double height_m = 0;        // of the rim above the floor; 0 is flat ground
  double exponent = 2;        // 1 is a cone; above 1 the wall leaves the floor without a kink

  bool operator==(const BowlSurface&) const = default;

  /// Horizontal distance from the floor.
  double distance_from_floor(const Eigen::Vector2d& ground) const;
  /// By the formula above, which goes on beyond the rim, where there is no bowl any more.
  double height_at(const Eigen::Vector2d& ground) const;
  /// Unit normal, upwards and inwards.
  Eigen::Vector3d normal_at(const Eigen::Vector2d& ground) const;
  bool inside_rim(const Eigen::Vector2d& ground) const;
  /// Where the rim is, seen from the origin, in a direction of any length.
  Eigen::Vector2d rim_towards(const Eigen::Vector2d& direction) const;

  /// First point of the bowl along a ray (direction of any length), to 1e-6 m. The bowl is seen from above
  /// and from inside: a ray that starts below it or comes through it from below meets nothing, nor does one
  /// that passes over the rim.
  std::optional<Eigen::Vector3d> intersect(const Eigen::Vector3d& origin,
                                           const Eigen::Vector3d& direction) const;
};

/// Floor twice the vehicle's length and three times its width; the wall as far again as the vehicle is long,
/// and half as high.
BowlSurface default_surface(const geometry::Vehicle& vehicle);

/// Every parameter that is no good, each under its own pointer. The vehicle has to stand on the floor.
Faults check(const BowlSurface& surface, const geometry::Vehicle& vehicle);

}  // namespace svchain::bowl
