#include "algorithms/geometry/import_ros.h"

#include "algorithms/geometry/import_fields.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/yaml_document.h"

namespace svchain::geometry {

namespace {

void read_camera(const json::Value& root, Camera& camera) {
  camera.image_size_px = image_size(root.required("image_width"), root.required("image_height"));
  const std::string model = root.required("distortion_model").choice({"equidistant", "plumb_bob"});
  const auto matrix = root.required("camera_matrix").required("data").items(9);
  const auto coefficients = root.required("distortion_coefficients").required("data");
  if (matrix.empty()) return;
  const Eigen::Vector2d focal_px(matrix[0].number(kFocalPx), matrix[4].number(kFocalPx));
  const Eigen::Vector2d centre_px(matrix[2].number(kCentrePx), matrix[5].number(kCentrePx));
  if (matrix[1].number() != 0) matrix[1].fault("expected 0: no lens model here has a skew");
  if (model == "equidistant") {
    const auto k = coefficients.numbers(4, kCoefficient);
    camera.lens = std::make_shared<KannalaBrandt>(focal_px, centre_px, std::array{k[0], k[1], k[2], k[3]});
  }
  if (model == "plumb_bob") {
    const auto k = coefficients.numbers(5, kCoefficient);
    camera.lens = std::make_shared<Pinhole>(focal_px, centre_px, std::array{k[0], k[1], k[2], k[3], k[4]});
  }
}

}  // namespace

Result<Rig> import_ros(const std::vector<std::filesystem::path>& files, const Rig& nominal) {
  return import_camera_files(files, nominal, [](const std::filesystem::path& file, Camera& camera) {
    return read_yaml(file, [&](const json::Value& root) { read_camera(root, camera); });
  });
}

}  // namespace svchain::geometry
