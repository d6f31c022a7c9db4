// Corners clicked by hand.

#include "algorithms/calibration/clicked_corners.h"

#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::calibration;
using Catch::Matchers::Contains;

namespace {

/// Cameras as a car has them; 4 x 3 = 12 inner corners, and a square's 4.
const geometry::Rig& car() {
  static const auto rig = geometry::read_rig(testing::project_folder() / "configs" / "rigs" / "car.json");
  REQUIRE(rig);
  return *rig;
}

std::vector<Chart> two_charts() {
  const auto charts = parse_charts(R"({"charts":[
    {"name":"front_left","type":"checkerboard","squares":[5,4],"square_m":0.25},
    {"name":"mat","type":"squares","side_m":0.8,"centres_m":[[0,0]]}]})",
                                   "charts.json");
  REQUIRE(charts);
  return *charts;
}

Result<std::vector<ClickedCorner>> parse(const std::string& items) {
  return parse_clicked_corners("{\"corners\":[" + items + "]}", "clicked.json", car(), two_charts());
}

std::string faults(const std::string& items) {
  const auto parsed = parse(items);
  REQUIRE_FALSE(parsed);
  std::string text;
  for (const auto& fault : parsed.error()) text += fault.text() + "\n";
  return text;
}

}  // namespace

TEST_CASE("clicked corners are read with camera and chart by their names") {
  const auto clicked = parse(R"({"camera":"rear","chart":"mat","corner":3,"pixel_px":[512.25,300.5]},
                                {"camera":"front","chart":"front_left","corner":11,"pixel_px":[0,0]})");
  REQUIRE(clicked);
  REQUIRE(clicked->size() == 2);
  CHECK(clicked->front().camera == 2);
  CHECK(clicked->front().chart == 1);
  CHECK(clicked->front().corner == 3);
  CHECK(clicked->front().pixel == Eigen::Vector2d(512.25, 300.5));
  CHECK(clicked->back().camera == 0);
  CHECK(clicked->back().chart == 0);
}

TEST_CASE("corners of a report are taken as they stand, those that were not found are passed over") {
  const auto clicked = parse_clicked_corners(
      R"({"date":"2026-01-01T00:00:00Z","accepted":false,"cameras":{},"corners":[
        {"camera":"left","chart":"mat","corner":0,"state":"fitted","pixel_px":[1,2],"predicted_px":[1,2]},
        {"camera":"left","chart":"mat","corner":1,"state":"rejected","pixel_px":[3,4],"predicted_px":[9,9]},
        {"camera":"left","chart":"mat","corner":2,"state":"not_found","predicted_px":[5,6]}]})",
      "report.json", car(), two_charts());
  REQUIRE(clicked);
  CHECK(clicked->size() == 2);
}

TEST_CASE("every fault of a file of clicked corners is told at once, with its place and the nearest name") {
  const std::string told = faults(
      R"({"camera":"fornt","chart":"front_left","corner":0,"pixel_px":[1,1]},
         {"camera":"front","chart":"front_lef","corner":0,"pixel_px":[1,1]},
         {"camera":"front","chart":"front_left","corner":12,"pixel_px":[1,1]},
         {"camera":"front","chart":"mat","corner":1.5,"pixel_px":[1,1]},
         {"camera":"front","chart":"mat","corner":1,"pixel_px":[1280,10]},
         {"camera":"front","chart":"mat","corner":1,"pixel_px":[12,10]},
         {"camera":"front","chart":"mat","corner":2},
         {"camera":"front","chart":"mat","corner":3,"pixel":[1,1],"pixel_px":[1,1]},
         {"camera":"front","chart":"mat","corner":0,"state":"lost","pixel_px":[1,1]})");
  CHECK_THAT(told, Contains("/corners/0/camera: expected front, right, rear or left, got \"fornt\", did you "
                            "mean \"front\"?"));
  CHECK_THAT(told,
             Contains("clicked.json:2:36: error: /corners/1/chart: no chart \"front_lef\", did you mean "
                      "\"front_left\"?"));
  CHECK_THAT(told,
             Contains("/corners/2/corner: expected 0 to 11, the corners of chart \"front_left\", got 12"));
  CHECK_THAT(told, Contains("/corners/3/corner: expected a whole number"));
  CHECK_THAT(told, Contains("/corners/4/pixel_px: lies outside the picture, expected one of 1280x720 px"));
  CHECK_THAT(told, Contains("/corners/5: corner 1 of chart \"mat\" is clicked in front's picture already"));
  CHECK_THAT(told, Contains("/corners/6: \"pixel_px\" is missing"));
  CHECK_THAT(told, Contains("/corners/7/pixel: unknown key, did you mean \"pixel_px\"?"));
  CHECK_THAT(told, Contains("/corners/8/state: expected fitted, held_out, rejected or not_found"));
  CHECK(std::count(told.begin(), told.end(), '\n') == 9);
}

TEST_CASE("without corners there is nothing to calibrate by") {
  CHECK_THAT(faults(""), Contains("/corners: expected at least one corner"));
}

TEST_CASE("beside a faulty rig and faulty charts a file's own faults are still found, and no others") {
  const auto told = parse_clicked_corners(
      R"({"corners":[{"camera":"front","chart":"any","corner":99,"pixel_px":[5000,1]},
                     {"camera":"rare","chart":"any","corner":99,"pixel_px":[5000,1]}]})",
      "clicked.json", {}, {});
  REQUIRE_FALSE(told);
  REQUIRE(told.error().size() == 1);
  CHECK(told.error().front().pointer == "/corners/1/camera");
}
