#include "algorithms/geometry/import_diy.h"

#include <Eigen/LU>
#include <cmath>

#include "algorithms/geometry/camera_files.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/opencv_yaml.h"

namespace svchain::geometry {

namespace {

Eigen::Matrix3d canvas_from_ground(const DiyCanvas& canvas) {
  const Eigen::Vector2d middle = (canvas.car_min_px + canvas.car_max_px).cast<double>() / 2;
  const double px_per_metre = 1 / canvas.metres_per_px;
  Eigen::Matrix3d m;
  m << 0, -px_per_metre, middle.x(),  //
      -px_per_metre, 0, middle.y(),   //
      0, 0, 1;
  return m;
}

/// Each camera's warp ends in a strip that lies with the camera looking up; the composite turns it into its
/// place.
Eigen::Matrix3d strip_from_canvas(const std::string& name, const DiyCanvas& canvas) {
  const double right = canvas.size_px.x() - 1;
  const double bottom = canvas.size_px.y() - 1;
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (name == "rear") m << -1, 0, right, 0, -1, bottom, 0, 0, 1;
  if (name == "left") m << 0, -1, bottom, 1, 0, 0, 0, 0, 1;
  if (name == "right") m << 0, 1, 0, -1, 0, right, 0, 0, 1;
  return m;
}

/// The part of the ground that this camera's strip covers.
Eigen::AlignedBox2d strip_ground(const std::string& name, const DiyCanvas& canvas) {
  Eigen::Vector2d from = {0, 0};
  Eigen::Vector2d to = canvas.size_px.cast<double>();
  if (name == "front") to.y() = canvas.car_min_px.y();
  if (name == "rear") from.y() = canvas.car_max_px.y();
  if (name == "left") to.x() = canvas.car_min_px.x();
  if (name == "right") from.x() = canvas.car_max_px.x();
  const Eigen::Matrix3d ground_from_canvas = canvas_from_ground(canvas).inverse();
  Eigen::AlignedBox2d box;
  box.extend((ground_from_canvas * from.homogeneous()).hnormalized());
  box.extend((ground_from_canvas * to.homogeneous()).hnormalized());
  return box;
}

void check_intrinsics(const Eigen::Matrix3d& k, const Eigen::Vector2d& size, const std::string& file,
                      Faults& faults) {
  const auto add = [&](std::string message) { faults.push_back({file, {}, {}, std::move(message)}); };
  if (!(k(0, 0) >= 1 && k(1, 1) >= 1)) add("camera_matrix: focal lengths expected at least 1 px");
  constexpr double kRounding = 1e-6;
  if (std::abs(k(0, 1)) > kRounding * std::abs(k(0, 0)) || k(1, 0) != 0 || k(2, 0) != 0 || k(2, 1) != 0 ||
      k(2, 2) != 1) {
    add("camera_matrix: expected fx 0 cx, 0 fy cy, 0 0 1");
  }
  if (!((size.array() >= 16).all() && (size.array() <= 16384).all()))
    add("resolution: expected 16 to 16384 px");
}

}  // namespace

Result<DiyCamera> read_diy_camera(const std::string& name, const std::filesystem::path& yaml_file,
                                  const DiyCanvas& canvas) {
  const std::string file = yaml_file.string();
  const auto read = read_opencv_yaml(yaml_file, {{"camera_matrix", 3, 3},
                                                 {"dist_coeffs", 4, 1},
                                                 {"resolution", 2, 1},
                                                 {"project_matrix", 3, 3},
                                                 {"scale_xy", 2, 1, false},
                                                 {"shift_xy", 2, 1, false}});
  if (!read) return tl::unexpected(read.error());
  const auto& matrices = *read;
  const Eigen::Matrix3d k = matrices[0];
  const Eigen::Vector4d distortion = matrices[1];
  const Eigen::Vector2d size_px = matrices[2];
  const Eigen::Matrix3d strip_from_ideal = matrices[3];
  const Eigen::Vector2d scale =
      matrices[4].size() > 0 ? Eigen::Vector2d(matrices[4]) : Eigen::Vector2d::Ones();
  const Eigen::Vector2d shift =
      matrices[5].size() > 0 ? Eigen::Vector2d(matrices[5]) : Eigen::Vector2d::Zero();

  Faults faults;
  check_intrinsics(k, size_px, file, faults);
  if (!(scale.minCoeff() > 0)) faults.push_back({file, {}, {}, "scale_xy: expected two numbers above 0"});
  constexpr double kSingular = 1e-12;
  if (!(std::abs((strip_from_ideal / strip_from_ideal.norm()).determinant()) > kSingular)) {
    faults.push_back({file, {}, {}, "project_matrix: is singular, expected a homography"});
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));

  Camera camera;
  camera.name = name;
  camera.image_size_px = size_px.cast<int>();
  camera.lens =
      std::make_shared<KannalaBrandt>(Eigen::Vector2d(k(0, 0), k(1, 1)), Eigen::Vector2d(k(0, 2), k(1, 2)),
                                      std::array{distortion[0], distortion[1], distortion[2], distortion[3]});

  Eigen::Matrix3d ideal_from_ray = k;
  ideal_from_ray.diagonal().head<2>().array() *= scale.array();
  ideal_from_ray.col(2).head<2>() += shift;
  const Eigen::Matrix3d ideal_from_ground =
      strip_from_ideal.inverse() * strip_from_canvas(name, canvas) * canvas_from_ground(canvas);
  return DiyCamera{camera, MappedGround(ideal_from_ground, ideal_from_ray, camera.image_size_px,
                                        strip_ground(name, canvas))};
}

Result<Rig> import_diy(const std::vector<std::filesystem::path>& yaml_files, const DiyCanvas& canvas) {
  const auto files = camera_files(yaml_files);
  if (!files) return tl::unexpected(files.error());
  const Eigen::Vector2d car_m = (canvas.car_max_px - canvas.car_min_px).cast<double>() * canvas.metres_per_px;
  Rig rig{{car_m.y(), car_m.x()}, {}};
  Faults faults;
  for (size_t i = 0; i < kCameraNames.size(); ++i) {
    auto read = read_diy_camera(kCameraNames[i], (*files)[i], canvas);
    const auto posed = read.and_then(
        [&](DiyCamera& diy) { return pose_camera(diy.ground, (*files)[i].string(), diy.camera); });
    if (posed)
      rig.cameras.push_back(std::move(read->camera));
    else
      faults.insert(faults.end(), posed.error().begin(), posed.error().end());
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return rig;
}

}  // namespace svchain::geometry
