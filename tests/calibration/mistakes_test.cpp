#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "algorithms/geometry/kannala_brandt.h"
#include "tests/calibration/calibration_scene.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::calibration;
using testing::parking_input;
using testing::parking_truth;

namespace {

enum CameraIndex : size_t { kFront, kRight, kRear, kLeft };

/// All reasons, "camera: reason" where it is a camera's.
std::vector<std::string> reasons(const Calibration& calibration) {
  std::vector<std::string> all = calibration.reasons;
  for (size_t c = 0; c < calibration.cameras.size(); ++c) {
    for (const auto& reason : calibration.cameras[c].reasons)
      all.push_back(calibration.rig.cameras[c].name + ": " + reason);
  }
  return all;
}

bool says(const Calibration& calibration, const std::string& part) {
  const auto all = reasons(calibration);
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& reason) { return reason.find(part) != std::string::npos; });
}

/// Paints over what a camera sees of a chart.
void cover(CalibrationInput& input, size_t camera, size_t chart) {
  std::vector<cv::Point> outline;
  const Chart& covered = input.charts[chart];
  for (const double x : {-3.2, 3.2}) {
    for (const double y : {-2.7, 2.7}) {
      const Eigen::Vector2d place = *covered.vehicle_from_chart * (covered.side_m * Eigen::Vector2d(x, y));
      const auto pixel = parking_truth().cameras[camera].see({place.x(), place.y(), 0});
      if (pixel) outline.emplace_back(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    }
  }
  std::vector<cv::Point> hull;
  cv::convexHull(outline, hull);
  cv::fillConvexPoly(input.pictures[camera], hull, {90, 95, 100});
}

}  // namespace

// One case, so that the pictures are rendered once.
TEST_CASE("what is wrong with pictures, charts or lenses is told") {
  SECTION("a mirrored picture is told by name") {
    for (const size_t camera : {kFront, kLeft}) {
      CalibrationInput input = parking_input();
      cv::flip(input.pictures[camera].clone(), input.pictures[camera], 1);
      const Calibration calibration = calibrate(input);
      CAPTURE(reasons(calibration));
      CHECK_FALSE(calibration.accepted());
      CHECK(says(calibration, "the picture of " + input.nominal.cameras[camera].name + " looks mirrored"));
    }
  }

  SECTION("swapped pictures are told by name, whether charts are posed or not") {
    for (const bool posed : {true, false}) {
      CalibrationInput input = parking_input();
      std::swap(input.pictures[kRight], input.pictures[kLeft]);
      if (!posed) {
        for (auto& chart : input.charts) chart.vehicle_from_chart.reset();
      }
      const Calibration calibration = calibrate(input);
      CAPTURE(posed, reasons(calibration));
      CHECK_FALSE(calibration.accepted());
      CHECK(says(calibration, "the pictures of right and left look swapped"));
    }
  }

  SECTION("a lens that is quite another is told") {
    for (const double focal_px : {275.0, 300.0}) {
      CalibrationInput input = parking_input();
      auto& camera = input.nominal.cameras[kRear];
      camera.lens = std::make_shared<geometry::KannalaBrandt>(
          Eigen::Vector2d(focal_px, focal_px), Eigen::Vector2d(640, 360), std::array<double, 4>{0, 0, 0, 0});
      const Calibration calibration = calibrate(input);
      CAPTURE(focal_px, reasons(calibration));
      CHECK_FALSE(calibration.accepted());
      CHECK((says(calibration, "rear: the lens does not fit") || says(calibration, "another lens")));
    }
  }

  SECTION("a lens that is off by its tolerance is refined, and the others are kept") {
    CalibrationInput input = parking_input();
    auto& camera = input.nominal.cameras[kRear];
    const auto& lens = dynamic_cast<const geometry::KannalaBrandt&>(*camera.lens);
    camera.lens = std::make_shared<geometry::KannalaBrandt>(
        1.004 * lens.focal_px(), lens.centre_px() + Eigen::Vector2d(2, -1.5), lens.k());
    const Calibration calibration = calibrate(input);
    CAPTURE(reasons(calibration));
    CHECK(calibration.accepted());
    CHECK(calibration.cameras[kRear].lens_change_px > 0.5);
    CHECK(calibration.cameras[kRear].rms_px < 0.1);
    CHECK(calibration.cameras[kFront].lens_change_px == 0);
  }

  SECTION("a chart that one camera does not see though it should is told") {
    CalibrationInput input = parking_input();
    cover(input, kLeft, 0);
    const Calibration calibration = calibrate(input);
    CAPTURE(reasons(calibration));
    CHECK_FALSE(calibration.accepted());
    CHECK(says(calibration, "chart \"front_left\" is seen by front only, expected left as well"));
  }

  SECTION("a picture that shows no chart has too few corners") {
    CalibrationInput input = parking_input();
    input.pictures[kRight].setTo(cv::Scalar::all(100));
    const Calibration calibration = calibrate(input);
    CHECK_FALSE(calibration.accepted());
    CHECK(says(calibration, "right: too few corners: 0, expected at least 8"));
  }

  SECTION("a chart that lies nowhere is told") {
    CalibrationInput input = parking_input();
    Chart chart = input.charts[0];
    chart.name = "extra";
    chart.squares = {7, 6};
    chart.vehicle_from_chart.reset();
    input.charts.push_back(chart);
    const Calibration calibration = calibrate(input);
    CHECK_FALSE(calibration.accepted());
    CHECK(says(calibration, "chart \"extra\" is seen by no camera"));
  }

  SECTION("pictures that are not the rig's are refused") {
    CalibrationInput input = parking_input();
    cv::resize(input.pictures[kRear], input.pictures[kRear], {640, 360});
    CHECK_THROWS_WITH(calibrate(input),
                      "the picture of rear: expected 1280x720 of 8 bits, as the rig has it, got 640x360");
    input.pictures.pop_back();
    CHECK_THROWS_WITH(calibrate(input), "expected 4 pictures, got 3");
  }
}
