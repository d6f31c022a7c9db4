#include "usecases/svchain_accuracy/rendered_exact.h"

#include <opencv2/imgcodecs.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/yaml_document.h"
#include "algorithms/scene/nominal_rig.h"
#include "usecases/svchain_accuracy/agreement.h"

namespace svchain::accuracy {

namespace {

using calibration::Chart;
using Eigen::Vector3d;
using geometry::Rig;
using geometry::Rigid3;

const std::vector<std::string> kNamesInSet = {"front", "right", "back", "left"};

Vector3d vector_of(const json::Value& column) {
  Vector3d vector = Vector3d::Zero();
  const auto rows = column.items(3);
  for (size_t i = 0; i < rows.size(); ++i) vector[static_cast<Eigen::Index>(i)] = rows[i].numbers(1).front();
  return vector;
}

/// `extrinsic` is camera from world, and the world the vehicle's frame.
Rigid3 pose_of(const json::Value& extrinsic) {
  const Vector3d turn = vector_of(extrinsic.required("rvec"));
  return Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())),
                vector_of(extrinsic.required("tvec"))}
      .inverse();
}

geometry::LensPtr lens_of(const json::Value& intrinsic) {
  std::array<double, 4> k = {0, 0, 0, 0};
  const auto d = intrinsic.required("D").items(4);
  for (size_t i = 0; i < d.size(); ++i) k[i] = d[i].numbers(1).front();
  const auto rows = intrinsic.required("K").items(3);
  if (rows.empty()) return nullptr;
  const auto x = rows[0].numbers(3), y = rows[1].numbers(3);
  return std::make_shared<geometry::KannalaBrandt>(Eigen::Vector2d(x[0], y[1]), Eigen::Vector2d(x[2], y[2]),
                                                   k);
}

/// Pads of 8 x 6 squares, their 6 along the line of sight; those at the sides are turned to the left.
std::vector<Chart> pads() {
  const auto pad = [](const std::string& name, double x_m, double y_m, double yaw_deg) {
    Chart chart;
    chart.name = name;
    chart.squares = {6, 8};
    chart.side_m = 0.25;
    chart.vehicle_from_chart = geometry::Pose2{x_m, y_m, geometry::radians(yaw_deg)};
    return chart;
  };
  return {pad("front", 3.5, 0, 0), pad("right", 0, -2, 90), pad("rear", -3.5, 0, 0), pad("left", 0, 2, 90)};
}

void add_corner(const calibration::CornerRecord& corner, const std::vector<Chart>& charts, const Rig& rig,
                Errors& px) {
  const auto& camera = rig.cameras[corner.camera];
  const auto& chart = charts[corner.chart];
  const Eigen::Vector2d ground = chart.vehicle_from_chart.value() *
                                 calibration::corners(chart)[static_cast<size_t>(corner.corner)].place_m;
  const auto pixel = camera.see({ground.x(), ground.y(), 0});
  if (pixel) px.add((*pixel - corner.found_px).norm());
}

}  // namespace

Result<RenderedExact> read_rendered_exact(const std::filesystem::path& folder) {
  RenderedExact set;
  set.given.vehicle = {4.8, 1.9};
  set.charts = pads();
  const Faults faults = geometry::read_yaml(folder / "calibration.yaml", [&](const json::Value& file) {
    const auto lens = lens_of(file.required("intrinsic"));
    for (size_t c = 0; c < kNamesInSet.size(); ++c)
      set.given.cameras.push_back({geometry::kCameraNames[c],
                                   {1920, 1536},
                                   lens,
                                   pose_of(file.required("extrinsic").required(kNamesInSet[c]))});
  });
  if (!faults.empty()) return tl::unexpected(faults);
  for (const auto& name : kNamesInSet) {
    const auto file = folder / (name + ".jpg");
    set.pictures.push_back(cv::imread(file.string()));
    if (set.pictures.back().empty()) return fail(file.string(), "cannot be read as a picture");
  }
  return set;
}

RenderedResult calibrate_rendered(const RenderedExact& set) {
  scene::Scene off;
  off.rig = set.given;
  calibration::CalibrationInput input;
  input.nominal = scene::nominal_rig(off);
  input.charts = set.charts;
  input.pictures = set.pictures;
  RenderedResult result{calibrate(input), {}};
  std::array<Errors, 4> ours, given;
  for (const auto& corner : result.made.corners) {
    if (corner.state != calibration::CornerState::kFitted) continue;
    add_corner(corner, set.charts, result.made.rig, ours[corner.camera]);
    add_corner(corner, set.charts, set.given, given[corner.camera]);
  }
  for (size_t c = 0; c < 4; ++c) {
    const auto& one = result.made.rig.cameras[c].vehicle_from_camera;
    const auto& other = set.given.cameras[c].vehicle_from_camera;
    result.cameras[c] = {ours[c].count(), ours[c].rms(), given[c].rms(),
                         geometry::degrees(one.rotation.angularDistance(other.rotation)),
                         1000 * (one.translation - other.translation).norm()};
  }
  return result;
}

}  // namespace svchain::accuracy
