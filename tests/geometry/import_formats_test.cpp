// Rigs from the files of Kalibr, ROS, WoodScape and OCamCalib, and back to those that can be written.

#include <fstream>

#include "algorithms/geometry/double_sphere.h"
#include "algorithms/geometry/eucm.h"
#include "algorithms/geometry/export_rig.h"
#include "algorithms/geometry/import_kalibr.h"
#include "algorithms/geometry/import_ocam.h"
#include "algorithms/geometry/import_ros.h"
#include "algorithms/geometry/import_woodscape.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/mei.h"
#include "algorithms/geometry/ocam.h"
#include "algorithms/geometry/pinhole.h"
#include "algorithms/geometry/polynomial.h"
#include "algorithms/geometry/yaml_document.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::geometry;
namespace fs = std::filesystem;

namespace {

const LensPtr kFisheye = std::make_shared<KannalaBrandt>(
    Eigen::Vector2d(330.25, 331), Eigen::Vector2d(639.5, 359.1), std::array{0.05, -0.0092, 1. / 3e3, 0.});
const LensPtr kPinhole = std::make_shared<Pinhole>(Eigen::Vector2d(300, 310), Eigen::Vector2d(640, 360),
                                                   std::array{-0.1, 0.01, 1e-3, -2e-3, 0.});
const LensPtr kMei = std::make_shared<Mei>(1.4, Eigen::Vector2d(700, 710), Eigen::Vector2d(640, 360),
                                           std::array{-0.2, 0.05, 1e-3, -2e-3});
const LensPtr kEucm =
    std::make_shared<Eucm>(EucmCurve{0.61, 1.07}, Eigen::Vector2d(340, 342), Eigen::Vector2d(640, 360));
const LensPtr kDoubleSphere = std::make_shared<DoubleSphere>(
    DoubleSphereCurve{-0.18, 0.59}, Eigen::Vector2d(340, 342), Eigen::Vector2d(640, 360));

/// A car with these lenses, and a pose for each camera that is its own.
Rig car(const std::vector<LensPtr>& lenses) {
  Rig rig{{4.8, 1.9}, {}};
  for (size_t i = 0; i < 4; ++i) {
    const Rigid3 pose{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5),
                      {i == 0   ? 2.4
                       : i == 2 ? -2.2
                                : 0.5,
                       0.25 * i, 0.7}};
    rig.cameras.push_back({kCameraNames[i], {1280, 720}, lenses[i], pose});
  }
  return rig;
}

Rig nominal() {
  return car({kFisheye, kFisheye, kFisheye, kFisheye});
}

struct Files {
  void add(const std::string& name, const std::string& text) {
    paths.push_back(folder.path() / name);
    std::ofstream(paths.back()) << text;
  }
  testing::TemporaryFolder folder;
  std::vector<fs::path> paths;
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

const std::string kWoodScape = R"({
    "extrinsic": {"quaternion": [0.5946970, -0.5837953, 0.3909954, -0.3910270], "translation": [3.7484, 0.0, 0.6577]},
    "intrinsic": {"aspect_ratio": 1.0, "cx_offset": 3.942, "cy_offset": -3.093, "height": 966.0, "k1": 339.749,
                  "k2": -31.988, "k3": 48.275, "k4": -7.201, "model": "radial_poly", "poly_order": 4, "width": 1280.0},
    "name": "FV"})";

const std::string kOcamText =
    R"(#polynomial coefficients for the DIRECT mapping function (ocam_model.ss in MATLAB)

5 -3.2e+02 0.000000e+00 7.0e-04 -1.1e-07 3.0e-10

#polynomial coefficients for the inverse mapping function (ocam_model.invpol in MATLAB)

2 502.654825 320

#center: "row" and "column", starting from 0 (C convention)

359.25 640.5

#affine parameters "c", "d", "e"

1.001 0.002 -0.003

#image size: "height" and "width"

720 1280
)";

}  // namespace

TEST_CASE("what Kalibr's format can hold comes back from it as it was") {
  for (const auto& lenses :
       {std::vector{kFisheye, kPinhole, kMei, kEucm}, {kDoubleSphere, kMei, kFisheye, kEucm}}) {
    const Rig rig = car(lenses);
    const auto written = export_kalibr(rig);
    REQUIRE(written);
    REQUIRE(written->size() == 1);
    Files files;
    files.add(written->front().name, written->front().text);
    const auto again = import_kalibr(files.paths, nominal());
    if (!again) FAIL(again.error().front().text());
    CHECK(rig_text(*again) == rig_text(rig));
  }
}

TEST_CASE("what ROS's format can hold comes back from it as it was") {
  const Rig rig = car({kFisheye, kPinhole, kFisheye, kPinhole});
  const auto written = export_ros(rig);
  REQUIRE(written);
  REQUIRE(written->size() == 4);
  Files files;
  for (const auto& file : *written) files.add(file.name, file.text);
  const auto again = import_ros(files.paths, nominal());
  if (!again) FAIL(again.error().front().text());
  CHECK(rig_text(*again) == rig_text(rig));
}

TEST_CASE("lenses that a format has no model for are told with camera and model") {
  const LensPtr bent = std::make_shared<Pinhole>(Eigen::Vector2d(300, 310), Eigen::Vector2d(640, 360),
                                                 std::array{0., 0., 0., 0., 0.01});
  const LensPtr polynomial = std::make_shared<Polynomial>(PolynomialCurve{{340, -32, 48, -7}},
                                                          Eigen::Vector2d(1, 1), Eigen::Vector2d(640, 360));
  const Rig rig = car({polynomial, kMei, bent, kFisheye});
  const auto kalibr = export_kalibr(rig);
  REQUIRE_FALSE(kalibr);
  REQUIRE(kalibr.error().size() == 2);
  CHECK(kalibr.error()[0].text().find(
            "/cameras/front/lens: kalibr has no model for this \"polynomial\" lens") != std::string::npos);
  CHECK(kalibr.error()[1].pointer == "/cameras/rear/lens");
  const auto ros = export_ros(rig);
  REQUIRE_FALSE(ros);
  REQUIRE(ros.error().size() == 2);
  CHECK(ros.error()[1].text().find("/cameras/right/lens: ros has no model for this \"mei\" lens") !=
        std::string::npos);
}

TEST_CASE("a Kalibr file for each camera tells it by name, T_cn_cnm1 and topics notwithstanding") {
  const std::string text =
      "cam0:\n  T_cam_imu:\n  - [1.0, 0.0, 0.0, 0.0]\n  cam_overlaps: []\n  camera_model: pinhole\n"
      "  distortion_coeffs: [-0.01, 2.0e-03, -1e-3, 0]\n  distortion_model: equidistant\n"
      "  intrinsics: [330.0, 331, 639.5, 359.5]\n  resolution: [1280, 720]\n  rostopic: /cam0/image_raw\n";
  Files files;
  for (const char* name : {"left.yaml", "front.yaml", "back.yaml"}) files.add(name, text);
  files.add("right.yaml", replaced(text, "[330.0, 331", "[333.0, 331"));
  const auto rig = import_kalibr(files.paths, nominal());
  if (!rig) FAIL(rig.error().front().text());
  CHECK(dynamic_cast<const KannalaBrandt&>(*rig->cameras[1].lens).focal_px().x() == 333);
  CHECK(dynamic_cast<const KannalaBrandt&>(*rig->cameras[0].lens).k()[1] == 0.002);
  CHECK(rig->cameras[2].vehicle_from_camera.translation.x() == -2.2);
  CHECK(rig->vehicle.length_m == 4.8);
}

TEST_CASE("what is wrong in a YAML file is told at its line, all of it at once") {
  auto text = export_kalibr(nominal())->front().text;
  text = replaced(text, "equidistant", "equidistent");
  text = replaced(text, "cam3:", "cam7:");
  text = replaced(text, "resolution: [1280, 720]", "resolution: [1280]");
  Files files;
  files.add("camchain.yaml", text);
  const auto rig = import_kalibr(files.paths, nominal());
  REQUIRE_FALSE(rig);
  REQUIRE(rig.error().size() == 3);
  const std::string file = files.paths[0].string();
  CHECK(rig.error()[0].text().find(file + ":6:15: error: /cam0/resolution:") == 0);
  CHECK(rig.error()[1].text().find(file + ":4:21: error: /cam0/distortion_model:") == 0);
  CHECK(rig.error()[1].text().find("equidistant") != std::string::npos);
  CHECK(rig.error()[2].message.find("cam3") != std::string::npos);
}

TEST_CASE("what is no YAML calibration at all is refused without a crash") {
  for (const std::string text :
       {"", "\n", "hello", "a: [1, 2", "a: b: c", "\x89PNG\r\n\x1a\n", "- a\n- b\n", "? [1, 2]\n: 3\n",
        "cam0: &a [*a]\n", "cam0: 3\n", "\t\t{", "cam0: \"\xff\"\n",
        "a: &a [x, x, x, x, x, x, x, x, x, x]\nb: &b [*a, *a, *a, *a, *a, *a, *a, *a, *a, *a]\n"
        "c: &c [*b, *b, *b, *b, *b, *b, *b, *b, *b, *b]\n"
        "d: &d [*c, *c, *c, *c, *c, *c, *c, *c, *c, *c]\n"
        "e: &e [*d, *d, *d, *d, *d, *d, *d, *d, *d, *d]\n"}) {
    INFO(text);
    Files files;
    files.add("camchain.yaml", text);
    const auto rig = import_kalibr(files.paths, nominal());
    REQUIRE_FALSE(rig);
    CHECK(rig.error().front().file == files.paths[0].string());
  }
  CHECK_FALSE(import_kalibr({"/nowhere/camchain.yaml"}, nominal()));
  const std::string deep(5000, '[');
  Files files;
  files.add("camchain.yaml", deep);
  CHECK_FALSE(import_kalibr(files.paths, nominal()));
}

TEST_CASE("ROS files with another distortion or a skew are refused, file by file") {
  const auto written = *export_ros(nominal());
  Files files;
  files.add("front.yaml", replaced(written[0].text, "equidistant", "rational_polynomial"));
  files.add("right.yaml", replaced(written[1].text, "[330.25, 0.0", "[330.25, 0.5"));
  files.add("rear.yaml", written[2].text);
  files.add("left.yaml", "image_width: 1280\n");
  const auto rig = import_ros(files.paths, nominal());
  REQUIRE_FALSE(rig);
  CHECK(rig.error().front().text().find("equidistant or plumb_bob") != std::string::npos);
  CHECK(rig.error()[1].text().find(files.paths[1].string() +
                                   ":7:18: error: /camera_matrix/data/1: expected 0") == 0);
  CHECK(rig.error().back().file == files.paths[3].string());
}

TEST_CASE("WoodScape's cameras keep their polynomial, their poses moved to the vehicle's middle") {
  Files files;
  files.add("a.json", kWoodScape);
  files.add("b.json", replaced(replaced(kWoodScape, "FV", "RV"), "3.7484", "-0.6516"));
  files.add("c.json", replaced(kWoodScape, "FV", "MVL"));
  files.add("d.json", replaced(replaced(kWoodScape, "FV", "MVR"), "339.749", "341"));
  const auto rig = import_woodscape(files.paths, nominal());
  if (!rig) FAIL(rig.error().front().text());
  const auto& front = rig->cameras[0];
  CHECK(front.image_size_px == Eigen::Vector2i(1280, 966));
  const auto& lens = dynamic_cast<const Polynomial&>(*front.lens);
  CHECK((lens.centre_px() - Eigen::Vector2d(639.5 + 3.942, 482.5 - 3.093)).norm() < 1e-12);
  CHECK(dynamic_cast<const Polynomial&>(*rig->cameras[1].lens).curve().k_px[0] == 341);
  // The nominal cameras are 2.4 m ahead and 2.2 m behind the middle: 0.1 m ahead on average.
  CHECK(front.vehicle_from_camera.translation.x() == Approx(0.1 + 2.2));
  CHECK(rig->cameras[2].vehicle_from_camera.translation.x() == Approx(0.1 - 2.2));
  CHECK(front.vehicle_from_camera.translation.z() == 0.6577);
  const Eigen::Vector3d axis = front.vehicle_from_camera.rotation * Eigen::Vector3d::UnitZ();
  CHECK(axis.x() > 0.8);  // looks ahead and down
  CHECK(axis.z() < -0.1);
  CHECK(parse_rig(rig_text(*rig), "a.json"));
}

TEST_CASE("WoodScape sets with a camera twice, or without, are told") {
  Files files;
  files.add("a.json", kWoodScape);
  files.add("b.json", kWoodScape);
  files.add("c.json", replaced(kWoodScape, "\"k2\"", "\"k9\""));
  const auto rig = import_woodscape(files.paths, nominal());
  REQUIRE_FALSE(rig);
  CHECK(rig.error().front().text().find(files.paths[1].string() + ":5:") == 0);
  CHECK(rig.error().front().text().find("a second file of this camera") != std::string::npos);
  CHECK(rig.error().back().message.find("MVL, the left camera") != std::string::npos);
}

TEST_CASE("OCamCalib's text gives its lens and image size, rows before columns") {
  Files files;
  for (const char* name : {"front.txt", "right.txt", "rear.txt", "left.txt"}) files.add(name, kOcamText);
  const auto rig = import_ocam(files.paths, nominal());
  if (!rig) FAIL(rig.error().front().text());
  CHECK(rig->cameras[3].image_size_px == Eigen::Vector2i(1280, 720));
  const auto& lens = dynamic_cast<const Ocam&>(*rig->cameras[3].lens);
  CHECK(lens.centre_row_column() == Eigen::Vector2d(359.25, 640.5));
  CHECK(lens.affine() == Eigen::Vector3d(1.001, 0.002, -0.003));
  CHECK(lens.inverse_polynomial() == std::vector<double>{502.654825, 320});
  CHECK(rig->cameras[3].vehicle_from_camera.translation.y() == 0.75);
}

TEST_CASE("OCamCalib's text cut off or with words in it is refused with the file") {
  Files files;
  files.add("front.txt", kOcamText.substr(0, kOcamText.find("#affine")));
  files.add("right.txt", replaced(kOcamText, "640.5", "six"));
  files.add("rear.txt", replaced(kOcamText, "502.654825", "1502"));
  files.add("left.txt", replaced(kOcamText, "\n2 502", "\n200 502"));
  const auto rig = import_ocam(files.paths, nominal());
  REQUIRE_FALSE(rig);
  REQUIRE(rig.error().size() == 4);
  CHECK(rig.error()[0].text() ==
        files.paths[0].string() + ": error: ends before the affine parameters c, d, e");
  CHECK(rig.error()[1].text() == files.paths[1].string() + ":11:1: error: expected a number, got \"six\"");
  CHECK(rig.error()[2].message.find("about 0 px on the axis") != std::string::npos);
  CHECK(rig.error()[3].where.line == 7);
}
