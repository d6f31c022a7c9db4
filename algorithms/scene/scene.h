#pragma once
// What a simulated scene consists of: a vehicle with its true rig on a painted ground under a sky, things
// that stand there, the vehicle's way over time, and what each camera makes of the light. World frame: the
// vehicle's frame at time 0. Colours are 8-bit, as an ideal camera would give them. Plain values.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/pose2.h"
#include "algorithms/geometry/rig.h"

namespace svchain::scene {

using geometry::Pose2;

struct Colour {
  uint8_t b = 0;
  uint8_t g = 0;
  uint8_t r = 0;
};

/// A convex piece of paint on the ground, corners in counter-clockwise order.
struct Patch {
  std::vector<Eigen::Vector2d> corners_m;
  Colour colour;
  double opacity = 1;
};

/// Contracts, "Charts": squares counted along x and y, the one at (-x, -y) black, half a square of white
/// around.
struct Checkerboard {
  std::string name;
  std::array<int, 2> squares = {0, 0};
  double square_m = 0;
  Pose2 world_from_chart;  // of its centre

  /// Corner (i, j) of the squares in the world, 0 <= i <= squares[0], 0 <= j <= squares[1].
  Eigen::Vector2d corner(int i, int j) const {
    return world_from_chart *
           Eigen::Vector2d((i - squares[0] / 2.0) * square_m, (j - squares[1] / 2.0) * square_m);
  }
};

/// A box that stands on the ground, upright, the middle of its bottom at the pose.
struct Box {
  Pose2 world_from_box;
  Eigen::Vector3d size_m = {0, 0, 0};  // along the pose's x and y, and up
  Colour colour;
};

/// An upright cylinder that stands on the ground.
struct Post {
  Eigen::Vector2d place_m = {0, 0};
  double radius_m = 0;
  double height_m = 0;
  Colour colour;
};

/// Asphalt: fine grain and large blotches, both as a standard deviation relative to the colour.
struct Ground {
  Colour colour = {97, 94, 92};
  double grain_contrast = 0.1;
  double grain_m = 0.01;
  double blotch_contrast = 0.05;
  double blotch_m = 1.5;
  double metres_per_texel = 0;  // of the finest level; 0: the vehicle's length over 960
  double half_extent_m = 0;     // of the finest level, about the world's origin; 0: 1280 texels
};

struct Sky {
  Colour zenith = {226, 186, 140};
  Colour horizon = {236, 228, 216};
  Colour skyline = {112, 116, 110};
  double skyline_deg = 6;  // the tallest there is
};

/// To and fro along an arc that touches the x axis at time 0, as a car drives with its wheel held turned.
struct Path {
  double travel_m = 0;  // to either side; 0: the vehicle stands
  double period_s = 10;
  double turn_radius_m = 20;
};

/// What a camera makes of the light 0..255 of one channel at distance q from its lens's centre, in half image
/// widths: 255 (gain / (1 + f1 q^2 + f2 q^4) light / 255)^gamma, and noise.
struct Response {
  std::array<double, 3> gain_bgr = {1, 1, 1};
  double gamma = 1;
  std::array<double, 2> falloff = {0, 0};
  double noise_sigma = 0;  // grey levels
};

/// How far off the nominal rig may be, each way and per axis of the vehicle (nominal_rig.h).
struct NominalError {
  std::optional<double> position_m;  // left out: 5 cm on a car, less on a toy
  double rotation_deg = 3;
};

struct Scene {
  geometry::Rig rig;
  Ground ground;
  std::vector<Patch> paint;  // in order, later over earlier
  std::vector<Checkerboard> charts;
  std::vector<Box> boxes;
  std::vector<Post> posts;
  Sky sky;
  Path path;
  std::array<Response, 4> responses;  // front, right, rear, left
  NominalError nominal;
  double frame_rate_hz = 30;
  double timestamp_jitter_ms = 0;  // each way
  uint64_t seed = 1;
};

}  // namespace svchain::scene
