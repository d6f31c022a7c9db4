#include "algorithms/geometry/import_woodscape.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/import_fields.h"
#include "algorithms/geometry/lens_fields.h"
#include "algorithms/geometry/polynomial.h"

namespace svchain::geometry {

namespace {

const std::vector<std::string> kTheirNames = {"FV", "MVR", "RV", "MVL"};  // in the order of kCameraNames

LensPtr read_intrinsic(const json::Value& in, const Eigen::Vector2i& size_px) {
  in.optional("model").choice({"radial_poly"});
  constexpr json::Range kAspect{0.1, 10};
  constexpr json::Range kOffsetPx{-8000, 8000};
  const Eigen::Vector2d focal_px(1, in.required("aspect_ratio").number(kAspect, 1));
  const Eigen::Vector2d offset_px(in.required("cx_offset").number(kOffsetPx),
                                  in.required("cy_offset").number(kOffsetPx));
  PolynomialCurve curve{};
  for (size_t i = 0; i < 4; ++i) {
    curve.k_px[i] = in.required("k" + std::to_string(i + 1)).number(kCoefficient);
  }
  const Eigen::Vector2d middle = (size_px.cast<double>().array() - 1) / 2;
  return std::make_shared<Polynomial>(curve, focal_px, Eigen::Vector2d(middle + offset_px));
}

Rigid3 read_extrinsic(const json::Value& out) {
  const auto translation = out.required("translation").numbers(3, {-100, 100});
  const auto list = out.required("quaternion");
  const auto q = list.numbers(4, {-1.001, 1.001});
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  constexpr double kNormTolerance = 1e-3;
  if (list && !(std::abs(rotation.norm() - 1) <= kNormTolerance)) {
    list.fault("expected a rotation, which is four numbers x, y, z, w of norm 1");
    return {};
  }
  return {rotation.normalized(), {translation[0], translation[1], translation[2]}};
}

/// Puts the file's camera into the rig; `from` holds the files read so far.
Faults read_camera(const std::filesystem::path& path, Rig& rig, std::vector<std::string>& from) {
  const auto document = json::Document::read(path);
  if (!document) return document.error();
  Faults faults;
  const json::Value root(*document, faults);
  const auto name = root.required("name");
  const auto found = std::find(kTheirNames.begin(), kTheirNames.end(), name.choice(kTheirNames));
  const auto in = root.required("intrinsic");
  Camera camera;
  camera.image_size_px = image_size(in.required("width"), in.required("height"));
  camera.lens = read_intrinsic(in, camera.image_size_px);
  camera.vehicle_from_camera = read_extrinsic(root.required("extrinsic"));
  if (found == kTheirNames.end()) return faults;
  const size_t i = static_cast<size_t>(found - kTheirNames.begin());
  camera.name = kCameraNames[i];
  if (!from[i].empty()) name.fault("a second file of this camera, after " + from[i]);
  from[i] = path.string();
  rig.cameras[i] = std::move(camera);
  return faults;
}

/// How far ahead of the origin the front and the rear camera are, on average.
double ahead_m(const Rig& rig) {
  return (rig.cameras[0].vehicle_from_camera.translation.x() +
          rig.cameras[2].vehicle_from_camera.translation.x()) /
         2;
}

}  // namespace

Result<Rig> import_woodscape(const std::vector<std::filesystem::path>& files, const Rig& nominal) {
  Rig rig = nominal;
  std::vector<std::string> from(kTheirNames.size());
  Faults faults;
  for (const auto& file : files) {
    const Faults more = read_camera(file, rig, from);
    faults.insert(faults.end(), more.begin(), more.end());
  }
  for (size_t i = 0; i < from.size(); ++i) {
    if (!from[i].empty()) continue;
    faults.push_back(
        {{}, {}, {}, "no file whose \"name\" is " + kTheirNames[i] + ", the " + kCameraNames[i] + " camera"});
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  const double shift_m = ahead_m(nominal) - ahead_m(rig);
  for (auto& camera : rig.cameras) camera.vehicle_from_camera.translation.x() += shift_m;
  return rig;
}

}  // namespace svchain::geometry
