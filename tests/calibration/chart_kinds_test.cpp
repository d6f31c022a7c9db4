// Charts of every kind, posed or not, clicked or found: the calibration comes out near the truth.

#include <algorithm>
#include <opencv2/aruco.hpp>

#include "algorithms/scene/nominal_rig.h"
#include "algorithms/scene/shapes.h"
#include "tests/calibration/calibration_scene.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::calibration;
using Eigen::Vector2d;
using geometry::Pose2;

namespace {

const scene::Colour kWhite{225, 225, 225}, kBlack{25, 25, 25};

scene::Scene bare_parking() {
  scene::Scene scene = testing::shipped_scene("parking");
  scene.charts.clear();
  return scene;
}

Pose2 placed(const Pose2& pose, const Vector2d& off_m) {
  const Vector2d at = pose * off_m;
  return {at.x(), at.y(), pose.yaw_rad};
}

void paint_squares(const Chart& chart, scene::Scene& scene) {
  const Pose2& pose = *chart.vehicle_from_chart;
  const double margin_m = chart.side_m / 2;
  for (const auto& centre : chart.centres_m)
    scene.paint.push_back(
        {scene::rectangle(placed(pose, centre), chart.side_m + 2 * margin_m, chart.side_m + 2 * margin_m),
         kWhite, 1});
  for (const auto& centre : chart.centres_m)
    scene.paint.push_back({scene::rectangle(placed(pose, centre), chart.side_m, chart.side_m), kBlack, 1});
}

/// A tag as OpenCV draws it, cell by cell.
void paint_tag(const Chart& chart, const Tag& tag, scene::Scene& scene) {
  constexpr int kCells = 8;
  cv::Mat cells;
  cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11)->drawMarker(tag.id, kCells, cells, 1);
  const Pose2 pose = placed(*chart.vehicle_from_chart, tag.place_m);
  const double cell_m = chart.side_m / kCells;
  scene.paint.push_back({scene::rectangle(pose, 1.25 * chart.side_m, 1.25 * chart.side_m), kWhite, 1});
  scene.paint.push_back({scene::rectangle(pose, chart.side_m, chart.side_m), kBlack, 1});
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      if (cells.at<uint8_t>(row, column) == 0) continue;
      const Vector2d middle = cell_m * Vector2d(column - 3.5, 3.5 - row);
      scene.paint.push_back({scene::rectangle(placed(pose, middle), cell_m, cell_m), kWhite, 1});
    }
  }
}

const std::vector<Pose2> kCorners = {
    {3.2, 1.9, 0.1}, {3.2, -1.9, -0.07}, {-3.2, -1.9, 0.09}, {-3.2, 1.9, -0.12}};
const std::vector<std::string> kNames = {"front_left", "front_right", "rear_right", "rear_left"};

CalibrationInput input_of(const scene::Scene& scene, std::vector<Chart> charts) {
  CalibrationInput input;
  input.nominal = scene::nominal_rig(scene);
  input.charts = std::move(charts);
  input.pictures = testing::pictures_of(scene);
  return input;
}

void check_accepted(const Calibration& calibration) {
  CAPTURE(calibration.reasons);
  for (const auto& camera : calibration.cameras) {
    CAPTURE(camera.reasons, camera.points, camera.inliers, camera.rms_px);
    CHECK(camera.reasons.empty());
  }
  CHECK(calibration.accepted());
}

}  // namespace

TEST_CASE("single squares calibrate") {
  scene::Scene scene = bare_parking();
  std::vector<Chart> charts;
  for (size_t k = 0; k < kCorners.size(); ++k) {
    Chart chart;
    chart.name = kNames[k];
    chart.type = ChartType::kSquares;
    chart.side_m = 0.35;
    chart.centres_m = {{-0.4, 0}, {0.4, 0.1}};
    chart.vehicle_from_chart = kCorners[k];
    paint_squares(chart, scene);
    charts.push_back(chart);
  }
  const Calibration calibration = calibrate(input_of(scene, charts));
  check_accepted(calibration);
  const auto error = testing::worst_error(calibration.rig, scene.rig);
  CHECK(error.rotation_deg < 0.1);
  CHECK(error.place_mm < 8);
}

TEST_CASE("a carpet of touching squares calibrates") {
  scene::Scene scene = bare_parking();
  Chart chart;
  chart.name = "carpet";
  chart.type = ChartType::kSquares;
  chart.side_m = 0.4;
  chart.vehicle_from_chart = Pose2{0.05, -0.03, 0.02};
  for (int i = -10; i <= 10; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const bool beside = std::abs(i) > 6 && std::abs(j) > 2;  // the carpet's four corners
      if (beside && (i + j) % 2 == 0) chart.centres_m.emplace_back(0.4 * i, 0.4 * j);
    }
  }
  scene.paint.push_back({scene::rectangle(*chart.vehicle_from_chart, 9.6, 6.4), kWhite, 1});
  for (const auto& centre : chart.centres_m)
    scene.paint.push_back(
        {scene::rectangle(placed(*chart.vehicle_from_chart, centre), chart.side_m, chart.side_m), kBlack, 1});
  const Calibration calibration = calibrate(input_of(scene, {chart}));
  check_accepted(calibration);
  const auto error = testing::worst_error(calibration.rig, scene.rig);
  CHECK(error.rotation_deg < 0.02);
  CHECK(error.place_mm < 2);
}

TEST_CASE("tags calibrate, posed or not, and do not mind which way up their makers hold them") {
  scene::Scene scene = bare_parking();
  std::vector<Chart> charts;
  for (size_t k = 0; k < kCorners.size(); ++k) {
    Chart chart;
    chart.name = kNames[k];
    chart.type = ChartType::kAprilTag36h11;
    chart.side_m = 0.5;
    const int id = 4 * static_cast<int>(k);
    chart.tags = {{id, {-0.35, 0}}, {id + 1, {0.35, 0.05}}};
    chart.vehicle_from_chart = kCorners[k];
    for (const auto& tag : chart.tags) paint_tag(chart, tag, scene);
    charts.push_back(chart);
  }
  CalibrationInput input = input_of(scene, charts);
  SECTION("posed") {
    const Calibration calibration = calibrate(input);
    check_accepted(calibration);
    const auto error = testing::worst_error(calibration.rig, scene.rig);
    CHECK(error.rotation_deg < 0.1);
    CHECK(error.place_mm < 8);
  }
  SECTION("not posed") {
    for (auto& chart : input.charts) chart.vehicle_from_chart.reset();
    const Calibration calibration = calibrate(input);
    check_accepted(calibration);
    for (const auto& [name, overlap] : calibration.overlaps) {
      CAPTURE(name);
      CHECK(overlap.points >= 6);
      CHECK(overlap.rms_cm < 2);  // a tag's edges are a cell wide, two or three pixels here
    }
  }
  SECTION("posed, each tag the other way up") {
    for (auto& chart : input.charts) {
      chart.vehicle_from_chart->yaw_rad += M_PI;
      for (auto& tag : chart.tags) tag.place_m = -tag.place_m;
    }
    const Calibration calibration = calibrate(input);
    check_accepted(calibration);
    CHECK(testing::worst_error(calibration.rig, scene.rig).rotation_deg < 0.1);
  }
}

TEST_CASE("corners clicked by hand calibrate without any picture") {
  CalibrationInput input = testing::parking_input();
  input.pictures.clear();
  const auto& truth = testing::parking_truth();
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    for (size_t k = 0; k < input.charts.size(); ++k) {
      const auto all = corners(input.charts[k]);
      for (size_t i = 0; i < all.size(); ++i) {
        const Vector2d place = *input.charts[k].vehicle_from_chart * all[i].place_m;
        const auto pixel = truth.cameras[c].see({place.x(), place.y(), 0});
        const bool aside = c % 2 == 0 ? (place.x() > 0) == (c == 0) : (place.y() > 0) == (c == 3);
        // A hand is good to the pixel.
        if (pixel && aside)
          input.clicked.push_back(
              {c, k, static_cast<int>(i), {std::round(pixel->x()), std::round(pixel->y())}});
      }
    }
  }
  const Calibration calibration = calibrate(input);
  check_accepted(calibration);
  const auto error = testing::worst_error(calibration.rig, truth);
  CHECK(error.rotation_deg < 0.6);
  CHECK(error.place_mm < 30);
}
