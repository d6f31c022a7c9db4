#include "algorithms/geometry/import_lens_table.h"

#include "algorithms/geometry/camera_files.h"
#include "algorithms/geometry/opencv_yaml.h"
#include "algorithms/geometry/table_lens.h"

namespace svchain::geometry {

namespace {

bool is_table(const std::filesystem::path& file) {
  return file.extension() == ".txt" || file.extension() == ".csv";
}

/// The ground on this camera's side of the vehicle.
Eigen::AlignedBox2d ground_beside(const std::string& name, const Vehicle& vehicle) {
  constexpr double kReachM = 4;
  const Eigen::Vector2d half(vehicle.length_m / 2, vehicle.width_m / 2);
  Eigen::AlignedBox2d box(Eigen::Vector2d(-half.array() - kReachM), Eigen::Vector2d(half.array() + kReachM));
  if (name == "front") box.min().x() = half.x();
  if (name == "rear") box.max().x() = -half.x();
  if (name == "left") box.min().y() = half.y();
  if (name == "right") box.max().y() = -half.y();
  return box;
}

Eigen::Matrix3d ideal_from_ray(const LensTableSetup& setup) {
  const double focal_px = setup.focal_mm / (setup.ideal_pixel_um * 1e-3);
  const Eigen::Vector2d middle = (setup.ideal_size_px.cast<double>().array() - 1) / 2;
  Eigen::Matrix3d m;
  m << focal_px, 0, middle.x(),  //
      0, focal_px, middle.y(),   //
      0, 0, 1;
  return m;
}

/// The one table among the files, or a fault.
Result<LensTable> table_among(const std::vector<std::filesystem::path>& files, const TableColumns& columns) {
  if (files.empty()) return fail({}, "no lens table (.txt or .csv) among the files given");
  if (files.size() > 1) return fail(files[1].string(), "a second lens table, after " + files[0].string());
  return read_lens_table(files[0], columns);
}

}  // namespace

Result<MappedGround> read_lens_table_ground(const std::string& name, const std::filesystem::path& yaml_file,
                                            const LensTableSetup& setup) {
  const auto read = read_opencv_yaml(yaml_file, {{"DTOIMGH", 3, 3}});
  if (!read) return tl::unexpected(read.error());
  constexpr double kMmPerM = 1000;
  Eigen::Matrix3d right_forward_mm_from_ground;
  right_forward_mm_from_ground << 0, -kMmPerM, 0,  //
      kMmPerM, 0, 0,                               //
      0, 0, 1;
  const Eigen::Matrix3d homography = read->front();
  return MappedGround(homography * right_forward_mm_from_ground, ideal_from_ray(setup), setup.ideal_size_px,
                      ground_beside(name, setup.vehicle));
}

Result<Rig> import_lens_table(const std::vector<std::filesystem::path>& files, const LensTableSetup& setup) {
  std::vector<std::filesystem::path> tables, homographies;
  for (const auto& file : files) (is_table(file) ? tables : homographies).push_back(file);
  const auto table = table_among(tables, setup.columns);
  const auto of_camera = camera_files(homographies);
  Faults faults;
  if (!table) faults = table.error();
  if (!of_camera) faults.insert(faults.end(), of_camera.error().begin(), of_camera.error().end());
  if (!faults.empty()) return tl::unexpected(std::move(faults));

  const auto lens = std::make_shared<TableLens>(*table, setup.pixel_um, setup.centre_px);
  Rig rig{setup.vehicle, {}};
  for (size_t i = 0; i < kCameraNames.size(); ++i) {
    Camera camera{kCameraNames[i], setup.image_size_px, lens, {}};
    const auto& file = (*of_camera)[i];
    const auto posed =
        read_lens_table_ground(camera.name, file, setup).and_then([&](const MappedGround& ground) {
          return pose_camera(ground, file.string(), camera);
        });
    if (posed)
      rig.cameras.push_back(std::move(camera));
    else
      faults.insert(faults.end(), posed.error().begin(), posed.error().end());
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return rig;
}

}  // namespace svchain::geometry
