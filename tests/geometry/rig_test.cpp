#include "algorithms/geometry/rig.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "algorithms/geometry/angles.h"
#include "algorithms/geometry/kannala_brandt.h"
#include "algorithms/geometry/table_lens.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::geometry;

namespace {

const std::string kFisheye =
    R"({"model":"kannala_brandt","focal_px":[330.5,331],"centre_px":[639.5,359.5],"k":[0.01,-0.02,0.003,0]})";
const std::string kTable =
    R"({"model":"table","angle_deg":[20,40,60,80],"height_mm":[0.45,0.9,1.34,1.77],"pixel_um":4.2,"centre_px":[640,360]})";
const std::string kPose = R"({"translation_m":[2.4,0.1,0.7],"quaternion_xyzw":[-0.5,0.5,-0.5,0.5]})";

std::string camera(const std::string& lens, const std::string& pose = kPose) {
  return "{\"image_size_px\":[1280,720],\n   \"lens\":" + lens + ",\n   \"vehicle_from_camera\":" + pose +
         "}";
}

/// A rig whose front camera is given; line 3 begins with it.
std::string rig_with(const std::string& front, const std::string& more = "") {
  const std::string other = camera(kFisheye);
  return "{\"vehicle\":{\"length_m\":4.8,\"width_m\":1.9},\n \"cameras\":{\n\"front\":" + front +
         ",\n\"right\":" + other + ",\n\"rear\":" + other + ",\n\"left\":" + other + "}" + more + "}";
}

Faults faults_of(const std::string& text) {
  const auto rig = parse_rig(text, "a.json");
  REQUIRE_FALSE(rig);
  return rig.error();
}

std::string only_fault(const std::string& text) {
  const auto faults = faults_of(text);
  REQUIRE(faults.size() == 1);
  return faults.front().text();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

}  // namespace

TEST_CASE("a rig is read with its four cameras clockwise from the front") {
  const auto rig = parse_rig(rig_with(camera(kFisheye)), "a.json");
  REQUIRE(rig);
  CHECK(rig->vehicle.length_m == 4.8);
  CHECK(rig->vehicle.width_m == 1.9);
  REQUIRE(rig->cameras.size() == 4);
  for (size_t i = 0; i < 4; ++i) CHECK(rig->cameras[i].name == kCameraNames[i]);
  const auto& front = rig->cameras[0];
  CHECK(front.image_size_px == Eigen::Vector2i(1280, 720));
  CHECK(front.vehicle_from_camera.translation == Eigen::Vector3d(2.4, 0.1, 0.7));
  // This quaternion looks forward: the optical axis is the vehicle's x.
  CHECK((front.vehicle_from_camera.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm() <
        1e-12);
  const auto& lens = dynamic_cast<const KannalaBrandt&>(*front.lens);
  CHECK(lens.focal_px() == Eigen::Vector2d(330.5, 331));
  CHECK(lens.k()[1] == -0.02);
  CHECK(lens.max_angle_rad() == radians(95));
}

TEST_CASE("a rig survives being written and read, to the last bit") {
  const auto rotated =
      R"({"translation_m":[0.1,-0.3333333333333333,1e-7],"quaternion_xyzw":[0.1,-0.2,0.3,0.9273618495495703]})";
  const auto first = parse_rig(rig_with(camera(kTable, rotated)), "a.json");
  REQUIRE(first);
  const std::string text = rig_text(*first);
  const auto second = parse_rig(text, "b.json");
  REQUIRE(second);
  CHECK(rig_text(*second) == text);
  for (size_t i = 0; i < 4; ++i) {
    const auto& a = first->cameras[i];
    const auto& b = second->cameras[i];
    CHECK(a.vehicle_from_camera.translation == b.vehicle_from_camera.translation);
    CHECK(a.vehicle_from_camera.rotation.coeffs() == b.vehicle_from_camera.rotation.coeffs());
    CHECK(a.lens->max_angle_rad() == b.lens->max_angle_rad());
    const Eigen::Vector3d ray(0.3, -0.5, 0.4);
    CHECK(*a.lens->project(ray) == *b.lens->project(ray));
  }
}

TEST_CASE("every lens model survives being written and read, to the last bit") {
  for (
      const std::string lens :
      {R"({"model":"polynomial","focal_px":[1,1.02],"centre_px":[640.1,359.5],"k":[339.749,-31.988,48.275,-7.201]})",
       R"({"model":"ocam","inverse_polynomial":[502.65,320,0.1],"affine":[1.001,0.002,-0.003],"centre_px":[359.1,640.3]})",
       R"({"model":"mei","xi":1.4,"focal_px":[700,710],"centre_px":[640,360],"k":[-0.2,0.05,0.001,-0.002]})",
       R"({"model":"eucm","alpha":0.61,"beta":1.07,"focal_px":[340,342],"centre_px":[640,360],"max_angle_deg":110})",
       R"({"model":"double_sphere","xi":-0.18,"alpha":0.59,"focal_px":[340,342],"centre_px":[640,360]})",
       R"({"model":"pinhole","focal_px":[300,310],"centre_px":[640,360],"k":[-0.3,0.1,0.001,-0.002,-0.012]})"}) {
    INFO(lens);
    const auto first = parse_rig(rig_with(camera(lens)), "a.json");
    if (!first) FAIL(first.error().front().text());
    const std::string text = rig_text(*first);
    const auto second = parse_rig(text, "b.json");
    REQUIRE(second);
    CHECK(rig_text(*second) == text);
    const Eigen::Vector3d ray(0.3, -0.5, 0.4);
    CHECK(*first->cameras[0].lens->project(ray) == *second->cameras[0].lens->project(ray));
  }
}

TEST_CASE("lenses that no camera has are refused where the file says so") {
  const auto fault_of = [](const std::string& lens) { return only_fault(rig_with(camera(lens))); };
  CHECK(fault_of(R"({"model":"polynomial","focal_px":[300,1],"centre_px":[640,360],"k":[300,0,0,0]})")
            .find("/cameras/front/lens/focal_px") != std::string::npos);
  CHECK(fault_of(R"({"model":"polynomial","focal_px":[1,1],"centre_px":[640,360],"k":[-300,0,0,0]})")
            .find("/cameras/front/lens: serves no picture") != std::string::npos);
  CHECK(
      fault_of(R"({"model":"ocam","inverse_polynomial":[320,502.65],"affine":[1,0,0],"centre_px":[360,640]})")
          .find("about 0 px on the axis") != std::string::npos);
  CHECK(
      fault_of(R"({"model":"ocam","inverse_polynomial":[502.65,320],"affine":[0,1,1],"centre_px":[360,640]})")
          .find("/cameras/front/lens/affine: expected c, d, e") != std::string::npos);
  CHECK(
      fault_of(R"({"model":"double_sphere","xi":-1,"alpha":0.5,"focal_px":[340,342],"centre_px":[640,360]})")
          .find("/cameras/front/lens/xi") != std::string::npos);
  CHECK(
      fault_of(
          R"({"model":"pinhole","focal_px":[300,310],"centre_px":[640,360],"k":[0,0,0,0,0],"max_angle_deg":90})")
          .find("expected at most 80.0000") != std::string::npos);
}

TEST_CASE("largest angles in radians survive being written in degrees") {
  auto rig = *parse_rig(rig_with(camera(kFisheye)), "a.json");
  for (const double angle : {1.0, 1.1, 1.2345678901234567, radians(87.3), radians(95), std::sqrt(2.0)}) {
    rig.cameras[0].lens = std::make_shared<KannalaBrandt>(
        Eigen::Vector2d(300, 300), Eigen::Vector2d(600, 300), std::array{0., 0., 0., 0.}, angle);
    const auto again = parse_rig(rig_text(rig), "b.json");
    REQUIRE(again);
    CHECK(again->cameras[0].lens->max_angle_rad() == angle);
  }
}

TEST_CASE("a lens that turns back before 95 degrees is written with an angle that is accepted again") {
  const auto turning = replaced(kFisheye, "[0.01,-0.02,0.003,0]", "[-0.0355,-0.0198,0.0261,-0.0097]");
  const auto rig = parse_rig(rig_with(camera(turning)), "a.json");
  REQUIRE(rig);
  CHECK(degrees(rig->cameras[0].lens->max_angle_rad()) == Approx(86.93).margin(0.2));
  CHECK(parse_rig(rig_text(*rig), "b.json"));
}

TEST_CASE("a point in front of a camera is seen where the pinhole's rule puts it, near the axis") {
  const auto rig = *parse_rig(rig_with(camera(kFisheye)), "a.json");
  const auto pixel = rig.cameras[0].see({102.4, 0.1 - 1, 0.7 - 2});  // 100 m ahead, 1 m right, 2 m below
  REQUIRE(pixel);
  CHECK(pixel->x() == Approx(639.5 + 330.5 * 0.01).margin(0.01));
  CHECK(pixel->y() == Approx(359.5 + 331 * 0.02).margin(0.01));
}

TEST_CASE("a point behind a camera or outside its image is not seen") {
  const auto rig = *parse_rig(rig_with(camera(kFisheye)), "a.json");
  CHECK_FALSE(rig.cameras[0].see({-5, 0, 0.7}));
  CHECK_FALSE(
      rig.cameras[0].see({2.4, 0.1, 0}));  // straight below, 90 degrees off, under the image's lower edge
  CHECK_FALSE(rig.cameras[0].see(rig.cameras[0].vehicle_from_camera.translation));
}

TEST_CASE("the image ends half a pixel around its outer pixels' centres") {
  Camera c;
  c.image_size_px = {16, 16};
  CHECK(c.contains({-0.5, 15.5}));
  CHECK_FALSE(c.contains({-0.51, 5}));
  CHECK_FALSE(c.contains({5, 15.51}));
}

TEST_CASE("a missing camera is a fault") {
  const auto text = replaced(rig_with(camera(kFisheye)), "\"rear\":", "\"raer\":");
  const auto faults = faults_of(text);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].message == "unknown key, did you mean \"rear\"? (known: front, right, rear or left)");
  CHECK(faults[0].pointer == "/cameras/raer");
  CHECK(faults[1].message == "\"rear\" is missing");
  CHECK(faults[1].pointer == "/cameras");
}

TEST_CASE("a camera that stands twice is a fault") {
  const auto text = replaced(rig_with(camera(kFisheye)), "\"rear\":", "\"front\":");
  CHECK(only_fault(text).find("/cameras/front: this key stands twice in its object") != std::string::npos);
}

TEST_CASE("an unknown lens model is told with those that are known") {
  const auto lens = replaced(kFisheye, "kannala_brandt", "kanala_brandt");
  const auto fault = only_fault(rig_with(camera(lens)));
  CHECK(fault.find("a.json:4:20: error: /cameras/front/lens/model: expected kannala_brandt") == 0);
  CHECK(fault.find("did you mean \"kannala_brandt\"?") != std::string::npos);
}

TEST_CASE("each value of a rig out of its range is a fault at its place") {
  struct Case {
    std::string what, with, pointer;
  };
  const std::vector<Case> cases = {
      {"[1280,720]", "[1280,15]", "/cameras/front/image_size_px/1"},
      {"[1280,720]", "[16385,720]", "/cameras/front/image_size_px/0"},
      {"[1280,720]", "[1280.5,720]", "/cameras/front/image_size_px/0"},
      {"[1280,720]", "[1280]", "/cameras/front/image_size_px"},
      {"[330.5,331]", "[0,331]", "/cameras/front/lens/focal_px/0"},
      {"[330.5,331]", "[330.5,-331]", "/cameras/front/lens/focal_px/1"},
      {"[639.5,359.5]", "[639.5,\"x\"]", "/cameras/front/lens/centre_px/1"},
      {"[0.01,-0.02,0.003,0]", "[0.01,-0.02,0.003]", "/cameras/front/lens/k"},
      {"\"k\":", "\"max_angle_deg\":0,\"k\":", "/cameras/front/lens/max_angle_deg"},
      {"\"k\":", "\"max_angle_deg\":181,\"k\":", "/cameras/front/lens/max_angle_deg"},
      {"\"k\":", "\"K\":", "/cameras/front/lens/K"},
      {"[2.4,0.1,0.7]", "[2.4,0.1,101]", "/cameras/front/vehicle_from_camera/translation_m/2"},
      {"[-0.5,0.5,-0.5,0.5]", "[-0.5,0.5,-0.5,0.51]", "/cameras/front/vehicle_from_camera/quaternion_xyzw"},
      {"[-0.5,0.5,-0.5,0.5]", "[0,0,0,0]", "/cameras/front/vehicle_from_camera/quaternion_xyzw"},
      {"\"length_m\":4.8", "\"length_m\":0.04", "/vehicle/length_m"},
      {"\"width_m\":1.9", "\"width_m\":51", "/vehicle/width_m"},
      {"\"width_m\":1.9", "\"width_mm\":1900", "/vehicle/width_mm"},
      {"\"cameras\"", "\"camera\"", "/camera"},
  };
  for (const auto& c : cases) {
    INFO(c.what << " -> " << c.with);
    const auto faults = faults_of(replaced(rig_with(camera(kFisheye)), c.what, c.with));
    CHECK(faults.front().pointer == c.pointer);
    CHECK(faults.front().where.line > 0);
  }
}

TEST_CASE("all faults of a rig are told at once") {
  auto text = rig_with(camera(replaced(kFisheye, "[330.5,331]", "[-1,0]"), replaced(kPose, "2.4", "2400")));
  text = replaced(text, "4.8", "480");
  CHECK(faults_of(text).size() == 4);
}

TEST_CASE("a quaternion a little off the unit is made one") {
  const auto rig = parse_rig(
      rig_with(camera(kFisheye, replaced(kPose, "[-0.5,0.5,-0.5,0.5]", "[-0.5,0.5,-0.5,0.501]"))), "a.json");
  REQUIRE(rig);
  CHECK(rig->cameras[0].vehicle_from_camera.rotation.norm() == Approx(1).epsilon(1e-15));
}

TEST_CASE("an angle beyond the turning point of the lens is refused with the angle that is possible") {
  const auto lens = replaced(kFisheye, "\"k\":[0.01,-0.02,0.003,0]",
                             "\"k\":[-0.3333333333333333,0,0,0],\"max_angle_deg\":60");
  const auto fault = only_fault(rig_with(camera(lens)));
  CHECK(fault.find("/cameras/front/lens/max_angle_deg: expected at most 57.2958") != std::string::npos);
}

TEST_CASE("an angle beyond the end of a table is refused") {
  const auto fault =
      only_fault(rig_with(camera(replaced(kTable, "\"pixel_um\"", "\"max_angle_deg\":81,\"pixel_um\""))));
  CHECK(fault.find("/cameras/front/lens/max_angle_deg: expected at most 80") != std::string::npos);
}

TEST_CASE("a table that falls is a fault at the height that falls") {
  const auto fault = only_fault(rig_with(camera(replaced(kTable, "1.34", "0.8"))));
  CHECK(fault == "a.json:4:76: error: /cameras/front/lens/height_mm/2: heights must not fall: 0.8 after 0.9");
}

TEST_CASE("a table with more angles than heights, or too few of both, is a fault") {
  CHECK(only_fault(rig_with(camera(replaced(kTable, ",1.77]", "]")))).find("as many heights as angles") !=
        std::string::npos);
  const auto two = replaced(replaced(kTable, ",60,80]", "]"), ",1.34,1.77]", "]");
  CHECK(only_fault(rig_with(camera(two))).find("at least 4 different heights") != std::string::npos);
}

TEST_CASE("a table in a file is found beside the rig and read as if it stood in it") {
  const testing::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "lenses");
  std::ofstream(folder.path() / "lenses" / "m.csv") << "angle,mm\n20,0.45\n40,0.9\n60,1.34\n80,1.77\n";
  const auto in_file = replaced(kTable, R"("angle_deg":[20,40,60,80],"height_mm":[0.45,0.9,1.34,1.77])",
                                R"("file":"lenses/m.csv","columns":{"angle":"angle","height":1})");
  std::ofstream(folder.path() / "rig.json") << rig_with(camera(in_file));
  const auto rig = read_rig(folder.path() / "rig.json");
  REQUIRE(rig);
  CHECK(rig_text(*rig) == rig_text(*parse_rig(rig_with(camera(kTable)), "a.json")));

  SECTION("an unknown column is a fault in the table's file") {
    const auto faults =
        parse_rig(rig_with(camera(replaced(in_file, "\"angle\":\"angle\"", "\"angle\":\"angel\""))),
                  (folder.path() / "rig.json").string());
    REQUIRE_FALSE(faults);
    CHECK(faults.error().front().file == (folder.path() / "lenses" / "m.csv").string());
    CHECK(faults.error().front().message.find("did you mean \"angle\"?") != std::string::npos);
  }
  SECTION("a missing file is a fault that names it") {
    const auto faults = parse_rig(rig_with(camera(replaced(in_file, "m.csv", "n.csv"))),
                                  (folder.path() / "rig.json").string());
    REQUIRE_FALSE(faults);
    CHECK(faults.error().front().file.find("n.csv") != std::string::npos);
  }
  SECTION("a file without columns is a fault") {
    CHECK(only_fault(rig_with(camera(replaced(in_file, R"(,"columns":{"angle":"angle","height":1})", ""))))
              .find("\"columns\" is missing") != std::string::npos);
  }
  SECTION("a file and an inline table together are a fault") {
    const auto both = replaced(kTable, "\"pixel_um\"",
                               R"("file":"lenses/m.csv","columns":{"angle":0,"height":1},"pixel_um")");
    CHECK(faults_of(rig_with(camera(both))).front().message.find("not both") != std::string::npos);
  }
}

TEST_CASE("a calibrated rig is read like any other, and $schema is accepted") {
  const auto text =
      replaced(rig_with(camera(kFisheye), ",\n\"calibration\":{\"date\":\"2026-01-01\",\"cameras\":{}}"),
               "{\"vehicle\"", "{\"$schema\":\"rig.schema.json\",\"vehicle\"");
  CHECK(parse_rig(text, "a.json"));
}

TEST_CASE("what a calibration says of itself survives rewriting, member by member in its order") {
  const std::string part = R"({"date":"2026-01-01","cameras":{"front":{"rms_px":0.1},"a":[1,{}]}})";
  const auto rig = parse_rig(rig_with(camera(kFisheye), ",\n\"calibration\":" + part), "a.json");
  REQUIRE(rig);
  CHECK(rig->calibration == part);
  const auto again = parse_rig(rig_text(*rig), "b.json");
  REQUIRE(again);
  CHECK(again->calibration == part);
  CHECK(rig_text(*again) == rig_text(*rig));
  CHECK(parse_rig(rig_with(camera(kFisheye)), "a.json")->calibration.empty());
  CHECK_FALSE(parse_rig(rig_with(camera(kFisheye), ",\n\"calibration\":[]"), "a.json"));
}

TEST_CASE("what is no rig at all is refused without a crash") {
  for (const char* text : {"", "null", "[]", "3", "{}", "{\"cameras\":[]}", "{\"cameras\":{\"front\":3}}",
                           "{\"vehicle\":null}"}) {
    INFO(text);
    CHECK_FALSE(parse_rig(text, "a.json"));
  }
  CHECK_FALSE(read_rig("/nowhere/rig.json"));
}
