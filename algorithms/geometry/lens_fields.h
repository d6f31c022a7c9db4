#pragma once
// What the lens models' entries in rig files have in common. Readers record faults in the value's list and
// return harmless defaults.

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "algorithms/geometry/lens.h"
#include "algorithms/json/value.h"

namespace svchain::geometry {

inline constexpr json::Range kFocalPx{1, 100000};
inline constexpr json::Range kCentrePx{-20000, 40000};
inline constexpr json::Range kCoefficient{-1e6, 1e6};
/// Points the spheres of `mei` and `double_sphere` are seen from; at -1 their pictures collapse.
inline constexpr json::Range kSphereShift{-0.99, 100};
inline constexpr json::Range kShare{0, 1};
inline constexpr json::Range kBeta{1e-3, 1e3};

Eigen::Vector2d pair(const json::Value& value, json::Range range);
nlohmann::ordered_json pair(const Eigen::Vector2d& v);

/// The largest angle a file asks for; where it asks for none, the usual one.
double max_angle_rad(const json::Value& lens);
/// Degrees that read back as exactly this angle, in as few digits as will do.
double exact_degrees(double angle_rad);

/// A lens made of faultless values, unless the file asks for a larger angle than the model can serve, or the
/// model serves next to none. `limit` says what happens at its limit: "the table ends".
LensPtr within_its_limit(LensPtr made, const json::Value& lens, const std::string& limit);

}  // namespace svchain::geometry
