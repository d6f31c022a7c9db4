// Calibration as a user runs it.

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/rig.h"
#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// The shipped car park seen by cameras of 640 x 360 px, on coarser ground: pictures, rigs and charts.
fs::path car_park() {
  static const TemporaryFolder folder;
  const fs::path made = folder.path() / "car_park";
  if (fs::exists(made)) return made;
  Json rig = small_rig();
  for (auto& [name, camera] : rig["cameras"].items()) {
    camera["image_size_px"] = {640, 360};
    camera["lens"]["focal_px"] = {165, 165};
    camera["lens"]["centre_px"] = {319.5, 179.5};
  }
  write_json(folder.path() / "rig.json", rig);
  Json scene = Json::parse(read_text(project_folder() / "configs" / "scenes" / "parking.json"));
  scene.erase("$schema");
  scene["rig"] = "rig.json";
  scene["ground"]["metres_per_texel"] = 0.01;
  scene["ground"]["half_extent_m"] = 6.4;
  write_json(folder.path() / "scene.json", scene);
  const auto outcome =
      svchain_program({"simulate", "--scene", folder.path() / "scene.json", "--output", made});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return made;
}

/// A calibration in the car park; what is given in `more` is added, or replaces what is said of its option.
Outcome calibrated(const fs::path& output, const Arguments& more = {}) {
  Arguments arguments = {"calibrate"};
  const Arguments usual = {
      "--rig",    car_park() / "nominal.rig.json", "--charts", car_park() / "charts.json",
      "--images", car_park() / "images",           "--output", output};
  for (size_t i = 0; i < usual.size(); i += 2) {
    if (std::find(more.begin(), more.end(), usual[i]) != more.end()) continue;
    arguments.insert(arguments.end(), {usual[i], usual[i + 1]});
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return svchain_program(arguments);
}

struct Apart {
  double turn_deg = 0, shift_mm = 0;  // of the worst camera
};

Apart from_truth(const fs::path& file) {
  const auto rig = geometry::read_rig(file);
  const auto truth = geometry::read_rig(car_park() / "truth.rig.json");
  REQUIRE((rig && truth));
  Apart most;
  for (size_t c = 0; c < 4; ++c) {
    const auto& a = rig->cameras[c].vehicle_from_camera;
    const auto& b = truth->cameras[c].vehicle_from_camera;
    most.turn_deg = std::max(most.turn_deg, geometry::degrees(a.rotation.angularDistance(b.rotation)));
    most.shift_mm = std::max(most.shift_mm, 1000 * (a.translation - b.translation).norm());
  }
  return most;
}

fs::path charts_without_poses(const fs::path& folder) {
  Json charts = Json::parse(read_text(car_park() / "charts.json"));
  for (auto& chart : charts["charts"]) chart.erase("pose");
  write_json(folder / "unposed.json", charts);
  return folder / "unposed.json";
}

}  // namespace

TEST_CASE("calibrate makes a rig that is right, says how right, and the rig runs a use case") {
  const TemporaryFolder folder;
  const auto rig = folder.path() / "rig.json", report = folder.path() / "report.json";
  const auto pictures = folder.path() / "pictures";
  const auto outcome = calibrated(rig, {"--report", report, "--pictures", pictures});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains("front") && Contains("24/24") && Contains("overlaps: front-right") &&
                              Contains("rig.json: calibrated"));
  const Apart before = from_truth(car_park() / "nominal.rig.json"), after = from_truth(rig);
  CHECK(before.turn_deg > 1);
  CHECK(before.shift_mm > 30);
  CHECK(after.turn_deg < 0.02);
  CHECK(after.shift_mm < 1.5);

  const Json said = Json::parse(read_text(report));
  CHECK(said["accepted"] == true);
  CHECK(said["corners"].size() == 96);
  CHECK(said["charts"] == Json::parse(read_text(car_park() / "charts.json"))["charts"]);
  const Json part = Json::parse(read_text(rig))["calibration"];
  CHECK(part["cameras"]["left"]["points"] == 24);
  CHECK(part["date"] == said["date"]);
  CHECK(part["overlaps"] == said["overlaps"]);

  CHECK(count_of(folder.path()) == 3);
  CHECK(count_of(pictures) == 5);
  CHECK(cv::imread(pictures / "rear.png").size() == cv::Size(640, 360));
  CHECK_FALSE(cv::imread(pictures / "stitched.png").empty());

  CHECK_THAT(svchain_program({"validate", rig}).out, Contains("rig.json: ok (rig)"));
  const auto run = svchain_program({"--usecase", "2dsv_2dsp", "--rig", rig, "--input", car_park() / "images",
                                    "--frames", "2", "--output", "none"});
  INFO(run.err);
  CHECK(run.status == 0);
}

TEST_CASE("charts that nobody has measured are placed by the calibration, about where the nominal rig is") {
  const TemporaryFolder folder;
  const auto rig = folder.path() / "rig.json", report = folder.path() / "report.json";
  const auto outcome = calibrated(rig, {"--charts", charts_without_poses(folder.path()), "--report", report});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Apart nominal = from_truth(car_park() / "nominal.rig.json"), after = from_truth(rig);
  CHECK(after.turn_deg < nominal.turn_deg / 3);
  CHECK(after.shift_mm < nominal.shift_mm / 3);
  const Json found = Json::parse(read_text(report))["charts"];
  const Json truth = Json::parse(read_text(car_park() / "charts.json"))["charts"];
  for (size_t k = 0; k < 4; ++k) {
    const Json &a = found[k]["pose"], &b = truth[k]["pose"];
    CHECK(a["x_m"].get<double>() == Approx(b["x_m"].get<double>()).margin(0.05));
    CHECK(a["y_m"].get<double>() == Approx(b["y_m"].get<double>()).margin(0.05));
    CHECK(a["yaw_deg"].get<double>() == Approx(b["yaw_deg"].get<double>()).margin(1));
  }
}

TEST_CASE("corners held out are half of all, and only they are reported on") {
  const TemporaryFolder folder;
  for (const std::string which : {"even", "odd"}) {
    INFO(which);
    const auto outcome = calibrated(folder.path() / "rig.json", {"--hold-out", which, "--report", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const Json report = Json::parse(outcome.out);
    CHECK(report["hold_out"] == which);
    for (const auto& camera : kCameras) CHECK(report["cameras"][camera]["points"] == 12);
    for (const auto& corner : report["corners"])
      CHECK((corner["state"] == "held_out") ==
            (corner["corner"].get<int>() % 2 == (which == "even" ? 0 : 1)));
    CHECK(from_truth(folder.path() / "rig.json").turn_deg < 0.02);
  }
}

TEST_CASE("a rejected calibration leaves its report and the pictures of its corners, but no rig") {
  const TemporaryFolder folder;
  write_stills(folder.path() / "images");
  for (const auto& camera : kCameras) {
    const auto file = folder.path() / "images" / (camera + ".png");
    cv::Mat image = cv::imread(file);
    cv::resize(image, image, {640, 360});
    cv::imwrite(file, image);
  }
  const auto report = folder.path() / "report.json", pictures = folder.path() / "pictures";
  const auto outcome = calibrated(folder.path() / "rig.json", {"--images", folder.path() / "images",
                                                               "--report", report, "--pictures", pictures});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("front: error: too few corners") && Contains("left: error: ") &&
                              Contains("the calibration is rejected, no rig is written"));
  const Json said = Json::parse(read_text(report));
  CHECK(said["accepted"] == false);
  CHECK(said["cameras"]["rear"]["accepted"] == false);
  CHECK_FALSE(said["cameras"]["rear"]["reasons"].empty());
  CHECK(count_of(pictures) == 4);
  CHECK(count_of(folder.path()) == 3);  // with the images
}

TEST_CASE("corners from a file do without pictures, and a report is such a file") {
  const TemporaryFolder folder;
  const auto report = folder.path() / "report.json", rig = folder.path() / "rig.json";
  REQUIRE(calibrated(folder.path() / "first.json", {"--report", report}).status == 0);
  const auto clicked = svchain_program({"calibrate", "--rig", car_park() / "nominal.rig.json", "--charts",
                                        car_park() / "charts.json", "--corners", report, "--output", rig});
  INFO(clicked.err);
  REQUIRE(clicked.status == 0);
  CHECK_THAT(clicked.err, Contains("24/24"));
  CHECK(from_truth(rig).turn_deg < 0.15);
  CHECK(from_truth(rig).shift_mm < 10);
}

TEST_CASE("the first of numbered pictures is taken") {
  const TemporaryFolder folder;
  const auto images = folder.path() / "images";
  for (const auto& camera : kCameras) {
    fs::create_directories(images / camera);
    fs::copy_file(car_park() / "images" / (camera + ".png"), images / camera / "000000.png");
    cv::imwrite(images / camera / "000001.png", cv::Mat(360, 640, CV_8UC3, cv::Scalar(9, 9, 9)));
  }
  const auto outcome = calibrated(folder.path() / "rig.json", {"--images", images});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(from_truth(folder.path() / "rig.json").turn_deg < 0.02);
}

TEST_CASE("all that is missing or wrong on the command line and in files is told at once") {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.path() / name; };
  const auto nothing = svchain_program({"calibrate"});
  CHECK(nothing.status == 2);
  for (const char* option : {"--rig: error: is missing", "--charts: error: is missing",
                             "--images: error: is missing", "--output: error: is missing"})
    CHECK_THAT(nothing.err, Contains(option));

  Json rig = small_rig();
  rig["cameras"]["left"]["lens"].erase("k");
  write_json(path("bad.rig.json"), rig);
  write_text(path("bad.charts.json"),
             R"({"charts":[{"name":"a","type":"chekerboard","squares":[4,3],"square_m":0.2}]})");
  write_text(path("bad.corners.json"), R"({"corners":[{"camera":"bonnet","chart":"a","corner":0}]})");
  write_text(path("taken"), "");
  const auto bad = svchain_program(
      {"calibrate", "--rig", path("bad.rig.json"), "--charts", path("bad.charts.json"), "--images",
       path("nowhere"), "--corners", path("bad.corners.json"), "--output", path("none/rig.json"), "--report",
       path("none/report.json"), "--pictures", path("taken"), "--hold-out", "evn"});
  CHECK(bad.status == 2);
  INFO(bad.err);
  CHECK_THAT(bad.err, Contains("/cameras/left/lens: \"k\" is missing"));
  CHECK_THAT(bad.err, Contains("did you mean \"checkerboard\"?"));
  CHECK_THAT(bad.err, Contains("nowhere: error: no such directory"));
  CHECK_THAT(bad.err, Contains("/corners/0/camera"));
  CHECK_THAT(bad.err, Contains("--output: error: "));
  CHECK_THAT(bad.err, Contains("--report: error: "));
  CHECK_THAT(bad.err, Contains("--pictures: error: ") && Contains("is a file"));
  CHECK_THAT(bad.err,
             Contains("--hold-out: error: expected even or odd, got \"evn\", did you mean \"even\"?"));
  CHECK(count_of(folder.path()) == 4);
}

TEST_CASE("pictures that are not the rig's are refused, one by one") {
  const TemporaryFolder folder;
  const auto images = folder.path() / "images";
  fs::copy(car_park() / "images", images);
  cv::imwrite(images / "right.png", cv::Mat(180, 320, CV_8UC3, cv::Scalar(9, 9, 9)));
  cv::imwrite(images / "left.png", cv::Mat(360, 320, CV_8UC3, cv::Scalar(9, 9, 9)));
  const auto outcome = calibrated(folder.path() / "rig.json", {"--images", images});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("right's picture is 320x180 px, the nominal rig expects 640x360") &&
                              Contains("left's picture is 320x360 px"));
  fs::remove(images / "rear.png");
  const auto missing = calibrated(folder.path() / "rig.json", {"--images", images});
  CHECK(missing.status == 2);
  CHECK_THAT(missing.err, Contains("nothing for camera \"rear\""));
  CHECK(count_of(folder.path()) == 1);
}

TEST_CASE("a report cannot be the rig's own file, and there is nothing to draw on without pictures") {
  const TemporaryFolder folder;
  const auto rig = folder.path() / "rig.json", corners = folder.path() / "corners.json";
  write_text(corners, R"({"corners":[{"camera":"front","chart":"front_left","corner":0,"pixel_px":[1,1]}]})");
  const auto outcome = svchain_program({"calibrate", "--rig", car_park() / "nominal.rig.json", "--charts",
                                        car_park() / "charts.json", "--corners", corners, "--output", rig,
                                        "--report", rig, "--pictures", folder.path() / "pictures"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--report: error: is the same file as --output") &&
                              Contains("--pictures: error: draws on pictures"));
  CHECK(count_of(folder.path()) == 1);
}
