// Calibration with real pictures, measured by corners that were left out of the fit.

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
namespace fs = std::filesystem;

namespace {

/// The report of a calibration with every second corner held out.
Json held_out(const fs::path& rig, const char* charts, const fs::path& images, const std::string& which) {
  const TemporaryFolder folder;
  const auto outcome = svchain_program(
      {"calibrate", "--rig", rig, "--charts", project_folder() / "configs" / "charts" / charts, "--images",
       images, "--hold-out", which, "--output", folder.path() / "rig.json", "--report", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a real car on its carpet is calibrated to about a centimetre, by corners the fit has not seen") {
  const auto data = data_folder();
  if (!data) {
    WARN("skipped: the real data are not there");
    return;
  }
  const TemporaryFolder folder;
  const auto carpet = *data / "real_car_carpet";
  Arguments import = {"import", "diy", "--output", folder.path() / "rig.json"};
  for (const char* camera : {"front", "back", "left", "right"})
    import.push_back(carpet / "yaml" / (std::string(camera) + ".yaml"));
  REQUIRE(svchain_program(import).status == 0);
  for (const std::string which : {"even", "odd"}) {
    INFO(which);
    const Json report = held_out(folder.path() / "rig.json", "car_carpet.json", carpet / "images", which);
    const Json overlap_cm = {
        {"front-right", 1.6}, {"right-rear", 1.6}, {"rear-left", 3.3}, {"left-front", 1.3}};
    for (const auto& [name, limit] : overlap_cm.items()) {
      INFO(name);
      CHECK(report["overlaps"][name]["points"].get<int>() >= 6);
      CHECK(report["overlaps"][name]["rms_cm"].get<double>() <= limit.get<double>());
    }
    const Json ground_cm = {{"front", 1.7}, {"right", 1.7}, {"rear", 1.5}, {"left", 2.3}};
    for (const auto& [name, limit] : ground_cm.items()) {
      INFO(name);
      const Json& camera = report["cameras"][name];
      CHECK(camera["points"].get<int>() >= 20);
      CHECK(camera["ground_rms_cm"].get<double>() <= limit.get<double>());
      CHECK(camera["ground_across_rms_cm"].get<double>() <= 0.7);
    }
  }
}

TEST_CASE("a real car in a garage, by its lens's table, is calibrated to a centimetre and a half") {
  const auto data = data_folder();
  if (!data) {
    WARN("skipped: the real data are not there");
    return;
  }
  const auto rig = project_folder() / "configs" / "rigs" / "garage.json";
  for (const std::string which : {"even", "odd"}) {
    INFO(which);
    const Json report = held_out(rig, "garage.json", *data / "real_garage_lens_table" / "chessboard", which);
    REQUIRE(report["overlaps"].size() == 4);
    for (const auto& [name, overlap] : report["overlaps"].items()) {
      INFO(name);
      CHECK(overlap["points"].get<int>() >= 6);
      CHECK(overlap["rms_cm"].get<double>() <= 1.4);
    }
  }
}
