#include <cmath>
#include <nlohmann/json.hpp>

#include "algorithms/geometry/lens_json.h"
#include "algorithms/geometry/rig.h"
#include "algorithms/json/layout.h"
#include "algorithms/json/value.h"

namespace svchain::geometry {

namespace {

using nlohmann::ordered_json;

constexpr json::Range kVehicleM{0.05, 50};
constexpr json::Range kImageSizePx{16, 16384};
constexpr json::Range kTranslationM{-100, 100};
constexpr double kNormTolerance = 1e-3;

Vehicle read_vehicle(const json::Value& vehicle) {
  vehicle.only({"length_m", "width_m"});
  return {vehicle.required("length_m").number(kVehicleM), vehicle.required("width_m").number(kVehicleM)};
}

Eigen::Vector2i read_image_size(const json::Value& size) {
  const auto items = size.items(2);
  if (items.empty()) return {0, 0};
  return {static_cast<int>(items[0].integer(kImageSizePx)), static_cast<int>(items[1].integer(kImageSizePx))};
}

Eigen::Quaterniond read_quaternion(const json::Value& quaternion) {
  const size_t before = quaternion.fault_count();
  const auto q = quaternion.numbers(4);
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  const double norm = rotation.norm();
  if (!quaternion || quaternion.fault_count() > before) return Eigen::Quaterniond::Identity();
  if (!(std::abs(norm - 1) <= kNormTolerance)) {
    quaternion.fault("expected a rotation, which is four numbers of norm 1, got norm " +
                     ordered_json(norm).dump());
    return Eigen::Quaterniond::Identity();
  }
  // A norm that is 1 but for the rounding of its last digits is left alone, so that rigs survive rewriting
  // unchanged.
  constexpr double kRounding = 1e-12;
  return std::abs(norm - 1) <= kRounding ? rotation : rotation.normalized();
}

Rigid3 read_pose(const json::Value& pose) {
  pose.only({"translation_m", "quaternion_xyzw"});
  const auto t = pose.required("translation_m").numbers(3, kTranslationM);
  return {read_quaternion(pose.required("quaternion_xyzw")), {t[0], t[1], t[2]}};
}

Camera read_camera(const std::string& name, const json::Value& camera) {
  camera.only({"image_size_px", "lens", "vehicle_from_camera"});
  Camera made;
  made.name = name;
  made.image_size_px = read_image_size(camera.required("image_size_px"));
  if (const auto lens = camera.required("lens")) made.lens = read_lens(lens);
  made.vehicle_from_camera = read_pose(camera.required("vehicle_from_camera"));
  return made;
}

/// As it stands in the text, its members in their order.
std::string calibration_of(const json::Value& calibration, const std::string& text) {
  calibration.members();  // an object, whose content is the calibration's own business
  return calibration.is_object() ? ordered_json::parse(text)["calibration"].dump() : "";
}

}  // namespace

Result<Rig> parse_rig(const std::string& text, const std::string& file) {
  auto document = json::Document::parse(text, file);
  if (!document) return tl::unexpected(std::move(document.error()));
  Faults faults;
  const json::Value root(*document, faults);
  root.only({"vehicle", "cameras", "calibration"});
  Rig rig;
  if (const auto vehicle = root.required("vehicle")) rig.vehicle = read_vehicle(vehicle);
  if (const auto cameras = root.required("cameras")) {
    cameras.only(kCameraNames);
    for (const auto& name : kCameraNames) {
      if (const auto camera = cameras.required(name)) rig.cameras.push_back(read_camera(name, camera));
    }
  }
  rig.calibration = calibration_of(root.optional("calibration"), text);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return rig;
}

Result<Rig> read_rig(const std::filesystem::path& path) {
  auto text = json::read_text(path);
  if (!text) return tl::unexpected(std::move(text.error()));
  return parse_rig(*text, path.string());
}

std::string rig_text(const Rig& rig) {
  ordered_json cameras = ordered_json::object();
  for (const auto& camera : rig.cameras) {
    const auto& t = camera.vehicle_from_camera.translation;
    const auto& q = camera.vehicle_from_camera.rotation;
    cameras[camera.name] = {
        {"image_size_px", {camera.image_size_px.x(), camera.image_size_px.y()}},
        {"lens", lens_json(*camera.lens)},
        {"vehicle_from_camera",
         {{"translation_m", {t.x(), t.y(), t.z()}}, {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}}}};
  }
  ordered_json root = {{"vehicle", {{"length_m", rig.vehicle.length_m}, {"width_m", rig.vehicle.width_m}}},
                       {"cameras", cameras}};
  if (!rig.calibration.empty()) root["calibration"] = ordered_json::parse(rig.calibration);
  return json::file_text(root);
}

}  // namespace svchain::geometry
