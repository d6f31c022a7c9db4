#include "links/geometric_alignment/geometric_alignment.h"

#include <algorithm>
#include <fstream>

#include "algorithms/scene/nominal_rig.h"
#include "algorithms/synthesis/lut_file.h"
#include "links/rig_table.h"
#include "tests/catch.h"
#include "tests/links/pictures.h"
#include "tests/links/simulated_cars.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

std::vector<std::byte> popped_lut(LinkHarness& link) {
  const auto frame = link.pop("lut");
  REQUIRE(frame);
  const auto bytes = frame->bytes();
  const uint32_t size = synthesis::GeometricLut(bytes).header().bytes;
  return {bytes.begin(), bytes.begin() + size};
}

/// The LUT that the first set gives.
std::vector<std::byte> first_lut(AlignmentAlone& alignment) {
  REQUIRE(text_of(alignment.configure()) == "");
  alignment.push_pictures();
  REQUIRE(alignment.failure() == "");
  return popped_lut(alignment);
}

nlohmann::json status(const LinkHarness& link) {
  return link.report()["geometric_alignment"];
}

/// How many LUTs are on their way, which are taken away with the absences between them.
int waiting_luts(LinkHarness& link) {
  for (int luts = 0;;) {
    if (link.pop("lut")) {
      ++luts;
    } else if (!link.pop_absence("lut")) {
      return luts;
    }
  }
}

LutErrors errors_of_rig(const geometry::Rig& rig, const SimulatedCar& car, const geometry::View& view) {
  return errors_of(OwnedLut(rig, view).bytes(), car.scene.rig, view);
}

std::string faults_with(const std::vector<std::pair<std::string, std::string>>& parameters) {
  AlignmentAlone alignment(parking_car(), "rig");
  for (const auto& [name, value] : parameters) alignment.parameter(name, value);
  return text_of(alignment.configure());
}

}  // namespace

TEST_CASE("who wants the rig gets it with the LUT, as calibration found it") {
  AlignmentAlone alignment(parking_car(), "charts", AlignmentAlone::Rig::kWanted);
  first_lut(alignment);
  const auto frame = alignment.pop("rig");
  REQUIRE(frame);
  const geometry::Rig rig = read_rig_table(frame->bytes());
  const geometry::Rig truth = parking_car().scene.rig, tape = scene::nominal_rig(parking_car().scene);
  for (size_t c = 0; c < truth.cameras.size(); ++c) {
    const auto off = [&](const geometry::Rig& other) {
      return (other.cameras[c].vehicle_from_camera.translation -
              truth.cameras[c].vehicle_from_camera.translation)
          .norm();
    };
    CHECK(off(rig) < 0.2 * off(tape));
  }
}

TEST_CASE("a rig is refused where alignment makes none, and the sources that do are named") {
  AlignmentAlone alignment(parking_car(), "features", AlignmentAlone::Rig::kWanted);
  CHECK_THAT(text_of(alignment.configure()),
             Contains("features gives no poses of the cameras") && Contains("rig, nominal or charts"));
}

TEST_CASE("charts: every pixel shows the ground it stands for to a quarter of a pixel, from poses by tape") {
  for (const SimulatedCar* car : {&parking_car(), &toy_car()}) {
    CAPTURE(car->input);
    AlignmentAlone alignment(*car, "charts");
    const geometry::View view = alignment.view();
    const double nominal_m = errors_of_rig(scene::nominal_rig(car->scene), *car, view).place_m;
    const double found_m = errors_of(first_lut(alignment), car->scene.rig, view).place_m;
    CHECK(nominal_m > 5 * view.metres_per_px);
    CHECK(found_m < 0.25 * view.metres_per_px);
    const auto said = status(alignment);
    CHECK(said["accepted"] == true);
    for (const char* camera : {"front", "right", "rear", "left"}) {
      CHECK(said["cameras"][camera]["inliers"].get<int>() >= 12);
      CHECK(said["cameras"][camera]["rms_px"].get<double>() < 0.2);
    }
  }
}

TEST_CASE("features: where two cameras blend, both show the same ground to half a pixel") {
  for (const SimulatedCar* car : {&parking_car(), &toy_car()}) {
    CAPTURE(car->input);
    AlignmentAlone alignment(*car, "features");
    const geometry::View view = alignment.view();
    const double nominal_m = errors_of_rig(scene::nominal_rig(car->scene), *car, view).blend_m;
    const double found_m = errors_of(first_lut(alignment), car->scene.rig, view).blend_m;
    CHECK(nominal_m > 5 * view.metres_per_px);
    CHECK(found_m < 0.5 * view.metres_per_px);
    CHECK(status(alignment)["overlaps"]["front-right"]["inliers"].get<int>() >= 8);
  }
}

TEST_CASE("a rig that is named is what charts start from, and charts of a file are what they go by") {
  const TemporaryFolder folder;
  const fs::path rig = folder.path() / "rig.json";
  std::ofstream(rig) << geometry::rig_text(scene::nominal_rig(toy_car().scene));
  AlignmentAlone usual(toy_car(), "charts"), named(toy_car(), "charts");
  named.setting("rig", rig.string());
  CHECK(first_lut(named) == first_lut(usual));

  AlignmentAlone misled(toy_car(), "charts");
  misled.parameter("charts", "garage");
  REQUIRE(text_of(misled.configure()) == "");
  misled.push_pictures();
  CHECK_THAT(misled.failure(), Contains("no LUT from source charts"));
}

TEST_CASE(
    "source nominal takes the poses of a measuring tape as they are, or those of the rig that is named") {
  AlignmentAlone tape(toy_car(), "nominal"), named(toy_car(), "nominal");
  const geometry::View view = tape.view();
  const auto as_bytes = [](const OwnedLut& lut) {
    return std::vector<std::byte>(lut.bytes().begin(), lut.bytes().end());
  };
  CHECK(first_lut(tape) == as_bytes(OwnedLut(scene::nominal_rig(toy_car().scene), view)));
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "rig.json") << geometry::rig_text(toy_car().scene.rig);
  named.setting("rig", (folder.path() / "rig.json").string());
  CHECK(first_lut(named) == as_bytes(OwnedLut(toy_car().scene.rig, view)));
}

TEST_CASE("the blend's width and shape are those of the parameters") {
  using synthesis::BlendCurve;
  for (const auto& [name, curve] : {std::pair("smooth", BlendCurve::kSmooth),
                                    {"linear", BlendCurve::kLinear},
                                    {"binary", BlendCurve::kBinary}}) {
    CAPTURE(name);
    AlignmentAlone alignment(toy_car(), "rig");
    alignment.parameter("blend_shape", name);
    alignment.parameter("blend_deg", 40);
    const OwnedLut expected(toy_car().scene.rig, alignment.view(), {40, curve});
    CHECK(first_lut(alignment) == std::vector<std::byte>(expected.bytes().begin(), expected.bytes().end()));
  }
}

TEST_CASE("a LUT is made once, and stored; the stored one is handed on as it was made") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "car.lut";
  AlignmentAlone charts(toy_car(), "charts");
  charts.parameter("store", file.string());
  const auto made = first_lut(charts);
  charts.push_pictures();
  CHECK(waiting_luts(charts) == 0);

  AlignmentAlone saved(toy_car(), "saved");
  saved.parameter("lut", file.string());
  CHECK(first_lut(saved) == made);
  CHECK(status(saved) ==
        nlohmann::json{{"source", "saved"}, {"accepted", true}, {"luts", 1}, {"rejected_while_running", 0}});
}

TEST_CASE("an alignment that is rejected at the start fails with the cameras and why, and stores nothing") {
  const TemporaryFolder folder;
  for (const std::string source : {"charts", "features"}) {
    AlignmentAlone alignment(toy_car(), source);
    alignment.parameter("store", (folder.path() / "car.lut").string());
    REQUIRE(alignment.configure().empty());
    alignment.push_black();
    CHECK_THAT(alignment.failure(),
               Contains("no LUT from source " + source) && Contains("front") && Contains("rear"));
    CHECK(waiting_luts(alignment) == 0);
    CHECK(status(alignment)["accepted"] == false);
    CHECK(status(alignment)["reasons"].size() >= 1);
    CHECK(alignment.buffers_in_use() == 0);
  }
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a LUT that cannot be stored fails with the path") {
  const TemporaryFolder folder;
  const fs::path inner = folder.path() / "inner";
  fs::create_directory(inner);
  AlignmentAlone alignment(toy_car(), "rig");
  alignment.parameter("store", (inner / "car.lut").string());
  REQUIRE(alignment.configure().empty());
  fs::remove(inner);
  alignment.push_pictures();
  CHECK_THAT(alignment.failure(), Contains((inner / "car.lut").string()) && Contains("could not be written"));
}

TEST_CASE("recalibrate makes a second LUT from the next set, and none from those behind it") {
  AlignmentAlone alignment(toy_car(), "charts");
  const auto first = first_lut(alignment);
  const auto answer = alignment.link().control("recalibrate", {});
  CHECK(answer["source"] == "charts");
  CHECK(answer["recalibrate"] == "with the next complete set of frames");
  alignment.push_pictures();
  CHECK(popped_lut(alignment) == first);  // the same pictures
  alignment.push_pictures();
  CHECK(waiting_luts(alignment) == 0);
  CHECK(alignment.link().control("status", {})["luts"] == 2);
}

TEST_CASE("a recalibration that is rejected leaves the LUT in force, says so, and may be tried again") {
  AlignmentAlone alignment(toy_car(), "features");
  first_lut(alignment);
  alignment.link().control("recalibrate", {});
  alignment.push_black();
  alignment.push_pictures();
  CHECK(alignment.failure() == "");
  CHECK(waiting_luts(alignment) == 0);
  CHECK(alignment.buffers_in_use() == 0);
  const auto kept = alignment.link().control("status", {});
  CHECK(kept == status(alignment));
  CHECK(kept["luts"] == 1);
  CHECK(kept["rejected_while_running"] == 1);
  CHECK(kept["accepted"] == false);
  CHECK_FALSE(kept["reasons"].empty());

  alignment.link().control("recalibrate", {});
  alignment.push_pictures();
  CHECK(waiting_luts(alignment) == 1);
  CHECK(status(alignment)["accepted"] == true);
}

TEST_CASE("what cannot be asked of geometric alignment is said") {
  AlignmentAlone alignment(toy_car(), "rig");
  REQUIRE(alignment.configure().empty());
  CHECK_THROWS_WITH(alignment.link().control("recalibrat", {}),
                    Contains("recalibrat") && Contains("expected recalibrate or status"));
  CHECK_THROWS_WITH(alignment.link().control("recalibrate", {}),
                    Contains("source rig looks at no frames, expected charts or features"));
}

TEST_CASE("times of stages are said in a run on the real clock and never in a virtual one") {
  for (const std::string source : {"charts", "features"}) {
    for (const bool is_virtual : {true, false}) {
      AlignmentAlone alignment(toy_car(), source);
      alignment.pace.virtual_clock = is_virtual;
      first_lut(alignment);
      CHECK(status(alignment).contains("stages_ms") == !is_virtual);
    }
  }
}

TEST_CASE("parameters that are missing, useless or wrong are faults before anything runs") {
  CHECK_THAT(faults_with({{"source", "saved"}}), Contains("lut") && Contains("missing"));
  CHECK_THAT(faults_with({{"lut", "car.lut"}}), Contains("goes with source saved, but the source is rig"));
  CHECK_THAT(faults_with({{"charts", "garage"}}), Contains("goes with source charts"));
  CHECK_THAT(
      faults_with({{"source", "saved"}, {"lut", "no.lut"}, {"store", "x.lut"}}),
      Contains("no.lut") && Contains("No such file") && Contains("goes with source rig, nominal, charts or"));
  CHECK_THAT(faults_with({{"source", "saved"}, {"lut", "no.lut"}, {"blend_shape", "binary"}}),
             Contains("blend_shape") && Contains("goes with source rig, nominal, charts or features"));
  CHECK_THAT(faults_with({{"source", "charts"}, {"charts", "garagr"}}),
             Contains("no such charts or file") && Contains("did you mean \"garage\"?"));
  CHECK_THAT(faults_with({{"store", "/no/such/folder/car.lut"}}), Contains("/no/such/folder does not exist"));
  const TemporaryFolder folder;
  CHECK_THAT(faults_with({{"store", folder.path().string()}}), Contains("is a folder"));
}

TEST_CASE("charts that nobody names are a fault where no scene tells of them") {
  const TemporaryFolder folder;
  const fs::path rig = folder.path() / "rig.json";
  std::ofstream(rig) << geometry::rig_text(toy_car().scene.rig);
  AlignmentAlone alignment(toy_car(), "charts");
  alignment.setting("rig", rig.string());
  alignment.setting("input", "some_folder");
  const std::string faults = text_of(alignment.configure());
  CHECK_THAT(faults, Contains("charts") && Contains("missing") && Contains("some_folder"));
}

TEST_CASE("a stored LUT of another view is refused before anything runs") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "car.lut";
  AlignmentAlone made(toy_car(), "rig"), used(toy_car(), "saved");
  made.parameter("store", file.string());
  first_lut(made);
  used.parameter("lut", file.string());
  used.setting("view", "size_px", {220, 270});
  CHECK_THAT(text_of(used.configure()), Contains("its view is 440 x 540 px, expected 220 x 270 px"));
}
