#include "algorithms/geometry/export_rig.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/pinhole.h"

namespace svchain::geometry {

namespace {

/// A YAML list, every number exact.
std::string list(const std::vector<double>& numbers) {
  std::string text = "[";
  for (const double number : numbers) {
    text += (text.size() > 1 ? ", " : "") + nlohmann::json(number).dump();
  }
  return text + "]";
}

template <class Made>
std::vector<double> intrinsics(std::vector<double> shape, const Made& lens) {
  for (const double number :
       {lens.focal_px().x(), lens.focal_px().y(), lens.centre_px().x(), lens.centre_px().y()}) {
    shape.push_back(number);
  }
  return shape;
}

std::string kalibr_lens(const char* model, const std::vector<double>& intrinsics, const char* distortion,
                        const std::vector<double>& coefficients) {
  return std::string("  camera_model: ") + model + "\n  intrinsics: " + list(intrinsics) +
         "\n  distortion_model: " + distortion + "\n  distortion_coeffs: " + list(coefficients) + "\n";
}

/// Nothing where Kalibr has no such model.
std::optional<std::string> kalibr_lens(const Lens& lens) {
  if (const auto* made = dynamic_cast<const KannalaBrandt*>(&lens)) {
    return kalibr_lens("pinhole", intrinsics({}, *made), "equidistant", {made->k().begin(), made->k().end()});
  }
  if (const auto* made = dynamic_cast<const Pinhole*>(&lens); made && made->k()[4] == 0) {
    return kalibr_lens("pinhole", intrinsics({}, *made), "radtan", {made->k().begin(), made->k().end() - 1});
  }
  if (const auto* made = dynamic_cast<const Mei*>(&lens)) {
    const auto k = made->k();
    return kalibr_lens("omni", intrinsics({made->xi()}, *made), "radtan", {k.begin(), k.end()});
  }
  if (const auto* made = dynamic_cast<const Eucm*>(&lens)) {
    return kalibr_lens("eucm", intrinsics({made->curve().alpha, made->curve().beta}, *made), "none", {});
  }
  if (const auto* made = dynamic_cast<const DoubleSphere*>(&lens)) {
    return kalibr_lens("ds", intrinsics({made->curve().xi, made->curve().alpha}, *made), "none", {});
  }
  return std::nullopt;
}

std::string ros_matrix(const std::string& name, int rows, const std::vector<double>& numbers) {
  return name + ":\n  rows: " + std::to_string(rows) +
         "\n  cols: " + std::to_string(numbers.size() / static_cast<size_t>(rows)) +
         "\n  data: " + list(numbers) + "\n";
}

template <class Made>
std::string ros_lens(const Made& lens, const std::string& distortion) {
  const double fx = lens.focal_px().x(), fy = lens.focal_px().y();
  const double cx = lens.centre_px().x(), cy = lens.centre_px().y();
  return ros_matrix("camera_matrix", 3, {fx, 0, cx, 0, fy, cy, 0, 0, 1}) + "distortion_model: " + distortion +
         "\n" + ros_matrix("distortion_coefficients", 1, {lens.k().begin(), lens.k().end()}) +
         ros_matrix("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         ros_matrix("projection_matrix", 3, {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0});
}

/// Nothing where ROS has no such model.
std::optional<std::string> ros_lens(const Lens& lens) {
  if (const auto* made = dynamic_cast<const KannalaBrandt*>(&lens)) return ros_lens(*made, "equidistant");
  if (const auto* made = dynamic_cast<const Pinhole*>(&lens)) return ros_lens(*made, "plumb_bob");
  return std::nullopt;
}

Fault no_model(const Camera& camera, const std::string& format, const std::string& known) {
  return {{},
          {},
          "/cameras/" + camera.name + "/lens",
          format + " has no model for this \"" + camera.lens->model() + "\" lens (it has: " + known + ")"};
}

}  // namespace

Result<std::vector<TextFile>> export_kalibr(const Rig& rig) {
  TextFile file{"camchain.yaml", {}};
  Faults faults;
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    const auto& camera = rig.cameras[i];
    const auto lens = kalibr_lens(*camera.lens);
    if (!lens) {
      faults.push_back(
          no_model(camera, "kalibr", "kannala_brandt, pinhole without k3, mei, eucm, double_sphere"));
      continue;
    }
    file.text += "cam" + std::to_string(i) + ":\n" + *lens + "  resolution: [" +
                 std::to_string(camera.image_size_px.x()) + ", " + std::to_string(camera.image_size_px.y()) +
                 "]\n  rostopic: /" + camera.name + "/image_raw\n";
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return std::vector{file};
}

Result<std::vector<TextFile>> export_ros(const Rig& rig) {
  std::vector<TextFile> files;
  Faults faults;
  for (const auto& camera : rig.cameras) {
    const auto lens = ros_lens(*camera.lens);
    if (!lens) {
      faults.push_back(no_model(camera, "ros", "kannala_brandt, pinhole"));
      continue;
    }
    files.push_back(
        {camera.name + ".yaml", "image_width: " + std::to_string(camera.image_size_px.x()) +
                                    "\nimage_height: " + std::to_string(camera.image_size_px.y()) +
                                    "\ncamera_name: " + camera.name + "\n" + *lens});
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return files;
}

}  // namespace svchain::geometry
