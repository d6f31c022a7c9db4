#include "algorithms/bowl/bowl_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace svchain::bowl {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCloseM = 1e-7;  // where Newton's steps end; what is left then is far less
constexpr int kMostSteps = 100;

/// From the nearest point of the floor to this one.
Eigen::Vector2d from_rectangle(const Eigen::Vector2d& half, const Eigen::Vector2d& p) {
  const Eigen::Array2d beyond = (p.array().abs() - half.array()).max(0);
  return {std::copysign(beyond.x(), p.x()), std::copysign(beyond.y(), p.y())};
}

/// The same from an ellipse. The nearest point is (A x / (A + t), B y / (B + t)) with A, B the squares of the
/// semi-axes, for the t at which it lies on the ellipse (Eberly, "Distance from a Point to an Ellipse").
/// Newton on 1 - 1/norm, the secular equation of trust regions (More, Sorensen): it is concave in t, so that
/// it converges from t = 0 without overshooting, for a circle in one step.
Eigen::Vector2d from_ellipse(const Eigen::Vector2d& half, const Eigen::Vector2d& p) {
  const Eigen::Array2d squared = half.array().square();
  const Eigen::Array2d scaled = half.array() * p.array();
  if ((scaled / squared).square().sum() <= 1) return {0, 0};
  double t = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const Eigen::Array2d shares = (scaled / (squared + t)).square();
    const double norm2 = shares.sum();
    const double step = (std::sqrt(norm2) - 1) * norm2 / (shares / (squared + t)).sum();
    t += step;
    // What is left after such a step is its square.
    if (!(step > 1e-5 * (squared.minCoeff() + t))) break;
  }
  return t * (p.array() / (squared + t)).matrix();
}

Eigen::Vector2d half_extent(const BowlSurface& surface) {
  return {surface.floor_length_m / 2, surface.floor_width_m / 2};
}

Eigen::Vector2d from_floor(const BowlSurface& surface, const Eigen::Vector2d& ground) {
  return surface.shape == FloorShape::kRectangle ? from_rectangle(half_extent(surface), ground)
                                                 : from_ellipse(half_extent(surface), ground);
}

/// Height and gradient of the bowl at a point, and its distance from the floor.
struct Slope {
  double distance = 0, height = 0;
  Eigen::Vector2d gradient = {0, 0};
};

Slope slope_at(const BowlSurface& surface, const Eigen::Vector2d& ground) {
  Slope slope;
  const Eigen::Vector2d away = from_floor(surface, ground);
  const double squared = away.squaredNorm();
  if (squared <= 0) return slope;
  slope.distance = std::sqrt(squared);
  const double part = slope.distance / surface.rise_m;
  slope.height = surface.height_m * (surface.exponent == 2 ? part * part : std::pow(part, surface.exponent));
  slope.gradient = away * (surface.exponent * slope.height / squared);
  return slope;
}

/// A ray and the height of its points above the bowl, a concave function of t.
struct RayOverBowl {
  const BowlSurface& surface;
  Eigen::Vector3d origin, direction;

  struct Place {
    double above, rate, distance;  // rate: of `above` over t
  };
  Eigen::Vector3d point(double t) const { return origin + t * direction; }
  Place at(double t) const {
    const Eigen::Vector3d p = point(t);
    const Slope slope = slope_at(surface, p.head<2>());
    return {p.z() - slope.height, direction.z() - slope.gradient.dot(direction.head<2>()), slope.distance};
  }
  /// Newton from a t below the bowl towards it, forwards or backwards; concave, so it does not overshoot. NaN
  /// where the ray does not come up to the bowl in that direction.
  double meet(double t, double forwards) const {
    const double close = kCloseM / direction.norm();
    for (int i = 0; i < kMostSteps; ++i) {
      const Place place = at(t);
      if (place.above >= 0) return t;
      if (!(place.rate * forwards > 0)) return std::nan("");
      const double step = -place.above / place.rate;
      t += step;
      if (std::abs(step) < close) break;
    }
    return t;
  }
};

/// Where the ray leaves the box around the rim: no point of the bowl is beyond. Negative where it is over.
double leaves_box(const Eigen::Vector2d& half, const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction) {
  double leaves = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0) continue;
    const double side = std::copysign(half[axis], direction[axis]);
    leaves = std::min(leaves, (side - origin[axis]) / direction[axis]);
  }
  return leaves;
}

}  // namespace

double BowlSurface::distance_from_floor(const Eigen::Vector2d& ground) const {
  return from_floor(*this, ground).norm();
}

double BowlSurface::height_at(const Eigen::Vector2d& ground) const {
  return slope_at(*this, ground).height;
}

Eigen::Vector3d BowlSurface::normal_at(const Eigen::Vector2d& ground) const {
  const Eigen::Vector2d gradient = slope_at(*this, ground).gradient;
  return Eigen::Vector3d(-gradient.x(), -gradient.y(), 1).normalized();
}

bool BowlSurface::inside_rim(const Eigen::Vector2d& ground) const {
  return distance_from_floor(ground) <= rise_m;
}

Eigen::Vector2d BowlSurface::rim_towards(const Eigen::Vector2d& direction) const {
  const Eigen::Vector2d unit = direction.normalized();
  double inside = 0, outside = half_extent(*this).norm() + rise_m;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (inside + outside);
    (inside_rim(middle * unit) ? inside : outside) = middle;
  }
  return inside * unit;
}

std::optional<Eigen::Vector3d> BowlSurface::intersect(const Eigen::Vector3d& origin,
                                                      const Eigen::Vector3d& direction) const {
  const RayOverBowl ray{*this, origin, direction};
  const Eigen::Vector2d half = half_extent(*this).array() + rise_m;
  double last = leaves_box(half, origin, direction);
  if (direction.z() < 0) last = std::min(last, -origin.z() / direction.z());
  if (!(last >= 0 && last < kInfinity)) return std::nullopt;

  const auto end = ray.at(last);
  if (end.above > kCloseM) return std::nullopt;  // over the rim, or away into the sky
  const double met = end.above >= -kCloseM ? last : ray.meet(last, -1);
  Eigen::Vector3d hit = ray.point(met);
  const Slope there = slope_at(*this, hit.head<2>());
  if (!(met >= 0) || there.distance > rise_m + kCloseM) return std::nullopt;
  hit.z() = there.height;  // exactly on it

  const auto start = ray.at(0);
  if (start.above >= -kCloseM) return hit;
  const double comes_over = ray.meet(0, 1);  // beyond the rim, else it comes through the bowl
  if (!(ray.at(comes_over).distance > rise_m)) return std::nullopt;
  return hit;
}

BowlSurface default_surface(const geometry::Vehicle& vehicle) {
  BowlSurface surface;
  surface.floor_length_m = 2 * vehicle.length_m;
  surface.floor_width_m = 3 * vehicle.width_m;
  surface.rise_m = vehicle.length_m;
  surface.height_m = vehicle.length_m / 2;
  return surface;
}

Faults check(const BowlSurface& surface, const geometry::Vehicle& vehicle) {
  constexpr double kLargestM = 1000, kSteepest = 20;
  Faults faults;
  const auto expect = [&](bool good, const std::string& name, const std::string& what, double got) {
    if (!good) faults.push_back({{}, {}, "/" + name, "expected " + what + ", got " + std::to_string(got)});
    return good;
  };
  const auto expect_floor = [&](const std::string& name, double extent, double of_vehicle) {
    return expect(extent >= of_vehicle && extent <= kLargestM, name,
                  "at least the vehicle's " + std::to_string(of_vehicle) + " m, and at most 1000 m", extent);
  };
  const bool long_enough = expect_floor("floor_length_m", surface.floor_length_m, vehicle.length_m);
  const bool wide_enough = expect_floor("floor_width_m", surface.floor_width_m, vehicle.width_m);
  const Eigen::Vector2d corner(vehicle.length_m / 2, vehicle.width_m / 2);
  if (long_enough && wide_enough && surface.distance_from_floor(corner) > 0) {
    faults.push_back({{},
                      {},
                      "/shape",
                      "expected a floor that the vehicle stands on, but the ellipse leaves "
                      "its corners out: make it longer or wider, or a rectangle"});
  }
  expect(surface.rise_m > 0 && surface.rise_m <= kLargestM, "rise_m", "more than 0, at most 1000 m",
         surface.rise_m);
  expect(surface.height_m >= 0 && surface.height_m <= kLargestM, "height_m", "0 to 1000 m", surface.height_m);
  expect(surface.exponent >= 1 && surface.exponent <= kSteepest, "exponent", "1 to 20", surface.exponent);
  return faults;
}

}  // namespace svchain::bowl
