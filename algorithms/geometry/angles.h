#pragma once
// Degrees for people, radians for code.

#include <numbers>

namespace svchain::geometry {

constexpr double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}
constexpr double degrees(double radians) {
  return radians * (180 / std::numbers::pi);
}

/// Largest angle at which a lens is used that says nothing of its own: a little over the half circle.
inline constexpr double kUsualMaxAngleRad = radians(95);
/// Rays this little beyond the largest angle still count: the rim's own rays come back rounded.
inline constexpr double kAngleSlackRad = 1e-9;

}  // namespace svchain::geometry
