#include <cmath>
#include <fstream>

#include "algorithms/geometry/import_diy.h"
#include "algorithms/geometry/import_lens_table.h"
#include "algorithms/geometry/opencv_yaml.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::geometry;
namespace fs = std::filesystem;

namespace {

/// Where each camera of a passenger car must about be: half a metre around, clockwise from the front.
void check_positions(const Rig& rig) {
  const double half_length = rig.vehicle.length_m / 2;
  const std::vector<Eigen::Vector3d> about = {
      {half_length, 0, 0.7}, {0.8, -1.05, 1.05}, {-half_length, 0, 0.95}, {0.8, 1.05, 1.05}};
  REQUIRE(rig.cameras.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    INFO(rig.cameras[i].name);
    CHECK((rig.cameras[i].vehicle_from_camera.translation - about[i]).norm() < 0.55);
  }
}

/// RMS distance in px between where the rig sees points of the ground and where its source sees them.
double reprojection_px(const MappedGround& ground, const Camera& camera, double step_m) {
  double sum = 0;
  int count = 0;
  const Eigen::Vector2d from = ground.shown_m().min();
  const Eigen::Vector2d to = ground.shown_m().max();
  for (double x = from.x(); x <= to.x(); x += step_m) {
    for (double y = from.y(); y <= to.y(); y += step_m) {
      const auto theirs = ground.see({x, y}, camera);
      const auto ours = camera.see({x, y, 0});
      if (!theirs || !ours) continue;
      sum += (*theirs - *ours).squaredNorm();
      ++count;
    }
  }
  REQUIRE(count > 50);
  return std::sqrt(sum / count);
}

std::string matrix(const std::string& name, int rows, int cols, const std::string& data) {
  return name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) +
         "\n   dt: d\n   data: [ " + data + " ]\n";
}

const std::string kSound =
    "%YAML:1.0\n---\n" + matrix("camera_matrix", 3, 3, "300., 0., 480., 0., 310., 320., 0., 0., 1.") +
    matrix("dist_coeffs", 4, 1, "-0.04, 0.003, -0.002, 0.") + matrix("resolution", 2, 1, "960, 640");

/// Four files, all holding `text`.
struct FourFiles {
  explicit FourFiles(const std::string& text) {
    for (const char* name : {"front", "back", "left", "right"}) {
      paths.push_back(folder.path() / (std::string(name) + ".yaml"));
      std::ofstream(paths.back()) << text;
    }
  }
  testing::TemporaryFolder folder;
  std::vector<fs::path> paths;
};

}  // namespace

TEST_CASE("the DIY project's real car gets cameras where they are, seeing the ground where its author does") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: no real recordings here");
    return;
  }
  const fs::path yaml = *data / "real_car_carpet" / "yaml";
  const std::vector<fs::path> files = {yaml / "front.yaml", yaml / "right.yaml", yaml / "back.yaml",
                                       yaml / "left.yaml"};
  const auto rig = import_diy(files);
  REQUIRE(rig);
  CHECK(rig->vehicle.length_m == 5);
  CHECK(rig->vehicle.width_m == 2);
  check_positions(*rig);
  for (size_t i = 0; i < 4; ++i) {
    INFO(kCameraNames[i]);
    const auto diy = read_diy_camera(kCameraNames[i], files[i], {});
    REQUIRE(diy);
    CHECK(reprojection_px(diy->ground, rig->cameras[i], 0.4) < 3.5);
  }
  CHECK(parse_rig(rig_text(*rig), "a.json"));
}

TEST_CASE("a canvas with the car further right shows the same ground further left") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: no real recordings here");
    return;
  }
  const fs::path front = *data / "real_car_carpet" / "yaml" / "front.yaml";
  const DiyCanvas shifted{{1300, 1700}, {550, 550}, {750, 1050}, 0.01};
  const auto a = read_diy_camera("front", front, {});
  const auto b = read_diy_camera("front", front, shifted);  // 50 px further right: 0.5 m
  REQUIRE(a);
  REQUIRE(b);
  const auto one = a->ground.see({4, 1}, a->camera);
  const auto other = b->ground.see({4, 1.5}, b->camera);
  REQUIRE(one);
  REQUIRE(other);
  CHECK((*one - *other).norm() < 1e-6);
}

TEST_CASE("the garage's lens table and homographies give cameras where they are") {
  const auto data = testing::data_folder();
  if (!data) {
    WARN("skipped: no real recordings here");
    return;
  }
  const fs::path garage = *data / "real_garage_lens_table";
  const fs::path yaml = garage / "yaml";
  const std::vector<fs::path> files = {yaml / "front1.yaml", yaml / "right1.yaml", yaml / "back1.yaml",
                                       yaml / "left1.yaml", garage / "m01_distortion.txt"};
  const auto rig = import_lens_table(files);
  REQUIRE(rig);
  CHECK(rig->vehicle.length_m == 5.023);
  check_positions(*rig);
  for (size_t i = 0; i < 4; ++i) {
    INFO(kCameraNames[i]);
    const auto ground = read_lens_table_ground(kCameraNames[i], files[i], {});
    REQUIRE(ground);
    CHECK(reprojection_px(*ground, rig->cameras[i], 0.25) < 3.5);
  }
  CHECK(parse_rig(rig_text(*rig), "a.json"));
}

TEST_CASE("a file without OpenCV's first line is read as well") {
  const FourFiles files(matrix("DTOIMGH", 3, 3, "1, 2, 3, 4, 5, 6, 7, 8, 10"));
  const auto read = read_opencv_yaml(files.paths[0], {{"DTOIMGH", 3, 3}});
  REQUIRE(read);
  CHECK(read->front()(2, 2) == 10);
}

TEST_CASE("a row is taken for a column") {
  const FourFiles files(matrix("k", 1, 4, "1, 2, 3, 4"));
  const auto read = read_opencv_yaml(files.paths[0], {{"k", 4, 1}});
  REQUIRE(read);
  CHECK(read->front()(3, 0) == 4);
}

TEST_CASE("what is missing in a camera's file or of another size is told, with the file") {
  const FourFiles files(kSound + matrix("projection_matrix", 3, 3, "1, 0, 0, 0, 1, 0, 0, 0, 1"));
  const auto rig = import_diy(files.paths);
  REQUIRE_FALSE(rig);
  REQUIRE(rig.error().size() == 4);
  CHECK(rig.error()[0].file == files.paths[0].string());
  CHECK(rig.error()[0].message.find("\"project_matrix\" is missing") == 0);

  const FourFiles small(kSound + matrix("project_matrix", 2, 3, "1, 0, 0, 0, 1, 0"));
  CHECK(import_diy(small.paths).error().front().message == "\"project_matrix\" expected as 3 x 3, got 2 x 3");
}

TEST_CASE("a singular homography is told, with the file") {
  const FourFiles files(kSound + matrix("project_matrix", 3, 3, "1, 2, 3, 2, 4, 6, 0, 0, 1"));
  const auto rig = import_diy(files.paths);
  REQUIRE_FALSE(rig);
  REQUIRE(rig.error().size() == 4);
  CHECK(rig.error()[0].text() ==
        files.paths[0].string() + ": error: project_matrix: is singular, expected a homography");
}

TEST_CASE("what is no OpenCV file at all is refused without a crash") {
  for (const std::string text :
       {"", "\n", "hello", "%YAML:1.0\n---\n", "%YAML:1.0\n---\na: [1, 2", "{\"a\":",
        "<?xml version=\"1.0\"?>", "\x89PNG\r\n\x1a\n", "%YAML:1.0\n---\nDTOIMGH: 3\n", "- a\n- b\n",
        "%YAML:1.0\n---\nDTOIMGH: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1, 2 ]\n"}) {
    INFO(text);
    const FourFiles files(text);
    const auto read = read_opencv_yaml(files.paths[0], {{"DTOIMGH", 3, 3}});
    REQUIRE_FALSE(read);
    CHECK(read.error().front().file == files.paths[0].string());
  }
  const testing::TemporaryFolder folder;
  CHECK_FALSE(read_opencv_yaml(folder.path(), {{"DTOIMGH", 3, 3}}));
  CHECK_FALSE(read_opencv_yaml("/nowhere/a.yaml", {{"DTOIMGH", 3, 3}}));
}

TEST_CASE("files must tell their camera by name, each camera once") {
  const auto faults =
      import_diy({"front.yaml", "rear.yaml", "back.yaml", "leftright.yaml", "side.yaml"}).error();
  REQUIRE(faults.size() == 5);
  CHECK(faults[0].text() == "back.yaml: error: a second file of the rear camera, after rear.yaml");
  CHECK(faults[1].file == "leftright.yaml");
  CHECK(faults[2].file == "side.yaml");
  CHECK(faults[3].message == "no file of the right camera among the 5 given");
  CHECK(faults[4].message == "no file of the left camera among the 5 given");
}

TEST_CASE("a set without its lens table, or with two, is refused") {
  CHECK(import_lens_table({"front1.yaml", "right1.yaml", "back1.yaml", "left1.yaml"})
            .error()
            .front()
            .message.find("no lens table") == 0);
  CHECK(import_lens_table({"a.txt", "b.csv"}).error().front().text() ==
        "b.csv: error: a second lens table, after a.txt");
}
