#pragma once
// Rigs made of a lens maker's table and, per camera, a homography DTOIMGH from the ground (mm, x right, y
// forward, origin in the middle of the car) to an undistorted image, in OpenCV YAML files. The undistorted
// image is an ideal pinhole's: r of its pixels is the table's paraxial height, f tan(angle). The homographies
// become poses (see mapped_ground.h).

#include <filesystem>
#include <vector>

#include "algorithms/geometry/lens_table.h"
#include "algorithms/geometry/mapped_ground.h"
#include "algorithms/geometry/rig.h"

namespace svchain::geometry {

/// What the files do not say. The defaults are those of the set that this format comes from: its author's
/// undistortion puts the lens's axis at pixel (640, 360) and the undistorted image's in its exact middle,
/// (674.5, 359.5).
struct LensTableSetup {
  Vehicle vehicle = {5.023, 1.960};
  Eigen::Vector2i image_size_px = {1280, 720};
  Eigen::Vector2d centre_px = {640, 360};
  double pixel_um = 4.2;
  TableColumns columns = {"FOV", "real height"};
  Eigen::Vector2i ideal_size_px = {1350, 720};
  double ideal_pixel_um = 9.75;
  double focal_mm = 1.289;
};

/// One camera's file: its map of the ground.
Result<MappedGround> read_lens_table_ground(const std::string& name, const std::filesystem::path& yaml_file,
                                            const LensTableSetup& setup);

/// One table (.txt or .csv) and four homographies, each camera told by its file's name: front, right, rear
/// (or back), left. All faults at once.
Result<Rig> import_lens_table(const std::vector<std::filesystem::path>& files,
                              const LensTableSetup& setup = {});

}  // namespace svchain::geometry
