#include "algorithms/geometry/import_kalibr.h"

#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/import_fields.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/yaml_document.h"

namespace svchain::geometry {

namespace {

/// `distortion_coeffs`, four zeros where the model is "none".
std::vector<double> distortion(const json::Value& camera, const std::string& model) {
  return model == "none" ? std::vector<double>(4, 0.0)
                         : camera.required("distortion_coeffs").numbers(4, kCoefficient);
}

/// What stands in front of the focal lengths in `intrinsics`, then those and the centre.
struct Intrinsics {
  std::vector<double> shape;
  Eigen::Vector2d focal_px = {1, 1};
  Eigen::Vector2d centre_px = {0, 0};
};

Intrinsics intrinsics(const json::Value& camera, const std::vector<json::Range>& shape) {
  const auto items = camera.required("intrinsics").items(shape.size() + 4);
  Intrinsics read{std::vector<double>(shape.size(), 0.5), {1, 1}, {0, 0}};
  if (items.empty()) return read;
  for (size_t i = 0; i < shape.size(); ++i) read.shape[i] = items[i].number(shape[i]);
  const size_t n = shape.size();
  read.focal_px = {items[n].number(kFocalPx), items[n + 1].number(kFocalPx)};
  read.centre_px = {items[n + 2].number(kCentrePx), items[n + 3].number(kCentrePx)};
  return read;
}

LensPtr pinhole(const json::Value& camera) {
  const auto in = intrinsics(camera, {});
  const auto model = camera.required("distortion_model").choice({"equidistant", "radtan", "none"});
  const auto k = distortion(camera, model);
  if (model == "equidistant") {
    return std::make_shared<KannalaBrandt>(in.focal_px, in.centre_px, std::array{k[0], k[1], k[2], k[3]});
  }
  return std::make_shared<Pinhole>(in.focal_px, in.centre_px, std::array{k[0], k[1], k[2], k[3], 0.0});
}

LensPtr omni(const json::Value& camera) {
  const auto in = intrinsics(camera, {kSphereShift});
  const auto model = camera.required("distortion_model").choice({"radtan", "none"});
  const auto k = distortion(camera, model);
  return std::make_shared<Mei>(in.shape[0], in.focal_px, in.centre_px, std::array{k[0], k[1], k[2], k[3]});
}

LensPtr eucm(const json::Value& camera) {
  const auto in = intrinsics(camera, {kShare, kBeta});
  camera.optional("distortion_model").choice({"none"});
  return std::make_shared<Eucm>(EucmCurve{in.shape[0], in.shape[1]}, in.focal_px, in.centre_px);
}

LensPtr double_sphere(const json::Value& camera) {
  const auto in = intrinsics(camera, {kSphereShift, kShare});
  camera.optional("distortion_model").choice({"none"});
  return std::make_shared<DoubleSphere>(DoubleSphereCurve{in.shape[0], in.shape[1]}, in.focal_px,
                                        in.centre_px);
}

void read_camera(const json::Value& value, Camera& camera) {
  if (!value) return;
  camera.image_size_px = image_size(value.required("resolution"));
  const std::string model = value.required("camera_model").choice({"pinhole", "omni", "eucm", "ds"});
  if (model == "pinhole") camera.lens = pinhole(value);
  if (model == "omni") camera.lens = omni(value);
  if (model == "eucm") camera.lens = eucm(value);
  if (model == "ds") camera.lens = double_sphere(value);
}

}  // namespace

Result<Rig> import_kalibr(const std::vector<std::filesystem::path>& files, const Rig& nominal) {
  Rig rig = nominal;
  if (files.size() != 1) {
    return import_camera_files(files, nominal, [](const std::filesystem::path& file, Camera& camera) {
      return read_yaml(file, [&](const json::Value& root) { read_camera(root.required("cam0"), camera); });
    });
  }
  Faults faults = read_yaml(files.front(), [&](const json::Value& root) {
    for (size_t i = 0; i < rig.cameras.size(); ++i) {
      read_camera(root.required("cam" + std::to_string(i)), rig.cameras[i]);
    }
  });
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return rig;
}

}  // namespace svchain::geometry
