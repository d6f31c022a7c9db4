#include "tests/calibration/small_calibration.h"

#include "tests/catch.h"
#include "tests/test_data.h"

namespace svchain::testing {

using namespace calibration;

Calibration small_calibration(double vehicle_length_m) {
  const auto rig = geometry::read_rig(project_folder() / "configs" / "rigs" / "car.json");
  REQUIRE(rig);
  Calibration made;
  made.rig = *rig;
  made.rig.vehicle.length_m = vehicle_length_m;
  Chart chart;
  chart.name = "board";
  chart.squares = {5, 4};
  chart.side_m = 0.25;
  chart.vehicle_from_chart = geometry::Pose2{3.5, 1, 0};
  made.charts = {chart};
  made.cameras.resize(4);
  made.cameras[0].rms_px = 0.1234567;
  made.cameras[0].points = 4;
  made.cameras[0].inliers = 3;
  made.cameras[0].sigma_rotation_deg = {0.01, 0.02, 0.03};
  made.cameras[0].ground_rms_cm = 0.7;
  made.overlaps["left-front"] = {0.5, 2};
  made.overlaps["front-right"] = {0.25, 3};
  made.stage_ms = {{"corners", 12}, {"accuracy", 3}};
  for (const auto state :
       {CornerState::kFitted, CornerState::kHeldOut, CornerState::kRejected, CornerState::kNotFound}) {
    const int n = static_cast<int>(state);
    const Eigen::Vector2d found(300 + 20 * n, 200);
    made.corners.push_back({0, 0, n, state, found + Eigen::Vector2d(3, 0), found});
  }
  return made;
}

}  // namespace svchain::testing
