// What a calibration says of itself.

#include "algorithms/calibration/calibration_json.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "algorithms/calibration/clicked_corners.h"
#include "tests/calibration/small_calibration.h"
#include "tests/catch.h"
#include "tests/json_schema.h"

using namespace svchain;
using namespace svchain::calibration;
using Json = nlohmann::ordered_json;
using testing::small_calibration;

namespace {

constexpr const char* kDate = "2026-11-22T12:00:00Z";

std::string report(const Calibration& made, HoldOut hold_out = HoldOut::kNone) {
  CalibrationInput input;
  input.nominal = made.rig;
  input.hold_out = hold_out;
  return report_text(input, {}, made, kDate);
}

}  // namespace

TEST_CASE("a report has figures with their units, charts where they were found, and every corner") {
  const Json json = Json::parse(report(small_calibration(), HoldOut::kOdd));
  CHECK(json["date"] == kDate);
  CHECK(json["accepted"] == true);
  CHECK(json["hold_out"] == "odd");
  CHECK(json["cameras"]["front"]["rms_px"] == 0.123457);
  CHECK(json["cameras"]["front"]["points"] == 4);
  CHECK(json["cameras"]["front"]["sigma_rotation_deg"] == Json({0.01, 0.02, 0.03}));
  CHECK(json["cameras"]["front"]["ground_rms_cm"] == 0.7);
  CHECK(json["overlaps"].front() == Json({{"rms_cm", 0.25}, {"points", 3}}));
  CHECK(json["stages_ms"]["corners"] == 12);
  CHECK(json["charts"][0]["pose"]["x_m"] == 3.5);
  REQUIRE(json["corners"].size() == 4);
  CHECK(json["corners"][2] == Json({{"camera", "front"},
                                    {"chart", "board"},
                                    {"corner", 2},
                                    {"state", "rejected"},
                                    {"pixel_px", {340.0, 200.0}},
                                    {"predicted_px", {343.0, 200.0}}}));
  CHECK_FALSE(json["corners"][3].contains("pixel_px"));
}

TEST_CASE("a report names the reasons of every camera and of the whole") {
  Calibration made = small_calibration();
  made.cameras[2].reasons = {"too few corners"};
  made.reasons = {"nothing agrees"};
  const Json json = Json::parse(report(made));
  CHECK(json["accepted"] == false);
  CHECK(json["reasons"] == Json({"nothing agrees"}));
  CHECK(json["cameras"]["rear"]["accepted"] == false);
  CHECK(json["cameras"]["rear"]["reasons"] == Json({"too few corners"}));
  CHECK(json["cameras"]["front"]["accepted"] == true);
}

TEST_CASE("a report states the limits as they hold for the vehicle") {
  const Json car = Json::parse(report(small_calibration()))["limits"];
  const Json toy = Json::parse(report(small_calibration(0.48)))["limits"];
  const AcceptanceLimits limits;
  CHECK(car["most_ground_rms_cm"] == limits.most_ground_rms_cm);
  CHECK(toy["most_ground_rms_cm"].get<double>() == Approx(0.1 * limits.most_ground_rms_cm));
  CHECK(car["most_shift_from_nominal_m"].get<double>() == Approx(0.05 * limits.most_shift_from_nominal));
  CHECK(toy["most_shift_from_nominal_m"].get<double>() == Approx(0.005 * limits.most_shift_from_nominal));
  CHECK(car["most_turn_from_nominal_deg"].get<double>() == Approx(3 * limits.most_turn_from_nominal));
  CHECK(toy["most_rms_px"] == limits.most_rms_px);
  CHECK(toy["least_inliers"] == limits.least_inliers);
}

TEST_CASE("a report's corners are read as clicked ones again") {
  const Calibration made = small_calibration();
  const auto clicked = parse_clicked_corners(report(made), "report.json", made.rig, made.charts);
  REQUIRE(clicked);
  REQUIRE(clicked->size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    CHECK((*clicked)[i].corner == made.corners[i].corner);
    CHECK((*clicked)[i].pixel == made.corners[i].found_px);
  }
}

TEST_CASE("reports fit their schemas, what is not known among them, and so does a calibrated rig") {
  if (!testing::has_schema_validator()) {
    WARN("skipped: python3 with jsonschema is not here");
    return;
  }
  Calibration made = small_calibration();
  CHECK(testing::fits_schema("calibration", report(made)));
  CHECK(testing::fits_schema("corners", report(made)));
  made.rig.calibration = rig_part(made, kDate);
  CHECK(testing::fits_schema("rig", geometry::rig_text(made.rig)));
  made.cameras[1].sigma_rotation_deg.x() = std::numeric_limits<double>::quiet_NaN();
  made.cameras[1].reasons = {"no corners"};
  CHECK(testing::fits_schema("calibration", report(made)));

  Json wrong = Json::parse(report(made));
  wrong["cameras"]["front"]["rms"] = 1;
  CHECK_FALSE(testing::fits_schema("calibration", wrong.dump()));
  wrong = Json::parse(geometry::rig_text(made.rig));
  wrong["calibration"]["cameras"]["front"].erase("rms_px");
  CHECK_FALSE(testing::fits_schema("rig", wrong.dump()));
  CHECK_FALSE(testing::fits_schema("corners", R"({"corners":[{"camera":"front","chart":"a","corner":1}]})"));
}

TEST_CASE("a rig keeps what its calibration says through reading and writing") {
  Calibration made = small_calibration();
  made.rig.calibration = rig_part(made, kDate);
  const std::string text = geometry::rig_text(made.rig);
  const auto again = geometry::parse_rig(text, "rig.json");
  REQUIRE(again);
  CHECK(again->calibration == made.rig.calibration);
  CHECK(geometry::rig_text(*again) == text);
  const Json part = Json::parse(text)["calibration"];
  CHECK(part["date"] == kDate);
  CHECK(part["cameras"]["front"].size() == 6);
  CHECK(part["cameras"]["front"]["accepted"] == true);
  CHECK(part["overlaps"]["left-front"]["points"] == 2);
}
