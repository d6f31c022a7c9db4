#pragma once
// The form of the default car's body as formulas, for a car of 4.8 m x 1.9 m: x forward, y left, z up,
// metres. Only the left half is spoken of. A place around the body is an angle from the front's middle (0)
// over the left side to the rear's (pi); seen from above the body is a superellipse with bowed ends.

#include <Eigen/Core>
#include <initializer_list>
#include <utility>
#include <vector>

namespace svchain::car {

inline constexpr float kLength = 4.8f, kWidth = 1.9f;
inline constexpr float kFloor = 0.17f;
inline constexpr float kWheelRadius = 0.335f;
inline constexpr float kArchRadius = 0.385f;
inline constexpr float kFrontAxle = 1.42f, kRearAxle = -1.40f;
inline constexpr float kShoulderRadius = 0.06f;  // of the edge between side and deck

/// A smooth curve through points that rise in x (Catmull and Rom), level beyond its ends.
class Curve {
 public:
  Curve(std::initializer_list<std::pair<float, float>> points) : points_(points) {}
  float operator()(float x) const;

 private:
  std::vector<std::pair<float, float>> points_;
};

/// The angle where the outline seen from above has this x (on the side) or this y (at an end).
float side_angle(float x);
float front_angle(float y);
float rear_angle(float y);

/// Height of what closes the body from above: bonnet, boot, and under the cabin what joins them.
float deck_height(float x, float y);

/// Where the body's skin begins: the floor, over a wheel its arch.
float lower_edge(float x);
/// Where its side ends and the rounded shoulder begins.
float upper_edge(float angle);

/// A point of the side, `outwards` metres off it.
Eigen::Vector3f side_point(float angle, float z, float outwards = 0);
/// A point of the shoulder, from the side (0) to the deck (1).
Eigen::Vector3f shoulder_point(float angle, float share);
/// A point of the deck, from the shoulder (0) to the car's middle plane (1), `upwards` metres above it.
Eigen::Vector3f deck_point(float angle, float share, float upwards = 0);

}  // namespace svchain::car
