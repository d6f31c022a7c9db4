#pragma once
// Rigs from the popular DIY surround view project: four OpenCV YAML files with camera_matrix, dist_coeffs
// (fisheye), resolution, project_matrix and, where the undistorted image is another than the camera's own,
// scale_xy and shift_xy. Its homographies become poses (see mapped_ground.h), its fisheye parameters
// Kannala-Brandt lenses.

#include <filesystem>
#include <vector>

#include "algorithms/geometry/mapped_ground.h"
#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

/// The composite that project_matrix leads to, forward up; the middle of the car is the vehicle's origin.
struct DiyCanvas {
  Eigen::Vector2i size_px = {1200, 1600};
  Eigen::Vector2i car_min_px = {500, 550};
  Eigen::Vector2i car_max_px = {700, 1050};
  double metres_per_px = 0.01;
};

/// One camera's file as it stands: lens and image size (no pose yet), and its map of the ground.
struct DiyCamera {
  Camera camera;
  MappedGround ground;
};
Result<DiyCamera> read_diy_camera(const std::string& name, const std::filesystem::path& yaml_file,
                                  const DiyCanvas& canvas);

/// The camera of each file is told by the file's name: front, right, rear (or back), left. All faults at
/// once.
Result<Rig> import_diy(const std::vector<std::filesystem::path>& yaml_files, const DiyCanvas& canvas = {});

}  // namespace svchain::geometry
