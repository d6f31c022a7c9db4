#pragma once
// A vehicle and the cameras on it. Vehicle frame ISO 8855: x forward, y left, z up, metres, origin on the
// ground below the middle of the vehicle's rectangle. Plain values.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/lens.h"
#include "algorithms/geometry/rigid3.h"
#include "algorithms/json/fault.h"

namespace svchain::geometry {

/// Names and order of the four cameras, clockwise.
inline const std::vector<std::string> kCameraNames = {"front", "right", "rear", "left"};

struct Vehicle {
  double length_m = 0;
  double width_m = 0;
};

struct Camera {
  std::string name;
  Eigen::Vector2i image_size_px = {0, 0};
  LensPtr lens;
  Rigid3 vehicle_from_camera;

  /// Whether a pixel lies on the image, its border pixels' outer halves included.
  bool contains(const Eigen::Vector2d& pixel) const;
  /// Pixel of a point in the vehicle's frame; nothing where the lens or the image does not reach it.
  std::optional<Eigen::Vector2d> see(const Eigen::Vector3d& point_in_vehicle) const;
};

struct Rig {
  Vehicle vehicle;
  std::vector<Camera> cameras;  // front, right, rear, left
  /// What a calibration says of itself: a JSON object that files keep, "" where there is none. It holds for
  /// these cameras, so who changes one has to clear it.
  std::string calibration = {};
};

/// Reads a rig file (contracts: "Rig"), with every fault in it: unknown keys, missing cameras, numbers out of
/// range, quaternions that are no rotation, tables that do not rise.
Result<Rig> read_rig(const std::filesystem::path& path);
/// The same from a text, `file` being what messages call it and what relative file names refer to.
Result<Rig> parse_rig(const std::string& text, const std::string& file);
/// The rig as the text of a rig file, reproducing every number exactly. Tables are written inline.
std::string rig_text(const Rig& rig);

}  // namespace svchain::geometry
