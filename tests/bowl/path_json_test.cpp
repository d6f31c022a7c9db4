#include "algorithms/bowl/path_json.h"

#include <algorithm>
#include <fstream>

#include "algorithms/bowl/viewpoint_presets.h"
#include "tests/bowl/bowls.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const std::string kGood = R"({"key_frames": [
  {"time_s": 0, "preset": "chase"},
  {"time_s": 2.5, "eye_m": [-3, 4, 2], "target_m": [0, 0, 0.5], "up": [0, 0.1, 1], "field_of_view_deg": 70},
  {"time_s": 4, "eye_m": [3, 4, 2], "target_m": [0, 0, 0]}]})";

std::string faults(const std::string& text) {
  const auto path = parse_path(text, "way.json", kCar, default_surface(kCar));
  std::string all;
  if (!path) {
    for (const Fault& fault : path.error()) all += fault.text() + "\n";
  }
  return all;
}

}  // namespace

TEST_CASE("a path file has presets and free viewpoints") {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "way.json") << kGood;
  const auto path = read_path(folder.path() / "way.json", kCar, default_surface(kCar));
  REQUIRE(path);
  CHECK_FALSE(path->loop());
  CHECK(path->end_s() == 4);
  CHECK((path->at(0).eye_m - preset("chase", kCar, default_surface(kCar))->eye_m).norm() < 1e-9);
  CHECK((path->at(2.5).eye_m - Eigen::Vector3d(-3, 4, 2)).norm() < 1e-9);
  CHECK(path->at(2.5).field_of_view_deg == Approx(70));
  CHECK(path->at(4).field_of_view_deg == Approx(60));
  CHECK_FALSE(read_path(folder.path() / "nowhere.json", kCar, default_surface(kCar)));
}

TEST_CASE("a path file that loops has to end where it begins") {
  const std::string open = R"({"loop": true, "key_frames": [
    {"time_s": 0, "preset": "left"}, {"time_s": 1, "preset": "right"}]})";
  CHECK_THAT(faults(open), Contains("/loop: expected a last key frame that is the first again"));
  std::string closed = open;
  closed.replace(closed.rfind("}]"), 1, R"(}, {"time_s": 2, "preset": "left"})");
  CHECK(faults(closed) == "");
}

TEST_CASE("all faults of a path file are told at once, with their places") {
  const std::string text = faults(R"({"lop": true, "key_frames": [
  {"time_s": 1, "preset": "chas"},
  {"time_s": 1, "preset": "top", "eye_m": [0, 0, 3]},
  {"preset": "top"},
  {"time_s": 3, "eye_m": [0, 0], "target_m": [0, 0, 0]},
  {"time_s": 4, "eye_m": [0, 0, 1], "target_m": [5, 0, 0], "field_of_view_deg": 200},
  {"time_s": 5},
  {"time_s": 6, "eye_m": [4, 4, 4]}]})");
  CHECK_THAT(text, Contains("/lop: unknown key, did you mean \"loop\"?"));
  CHECK_THAT(text,
             Contains("way.json:2:27: error: /key_frames/0/preset") && Contains("did you mean \"chase\"?"));
  CHECK_THAT(text, Contains("/key_frames/1/time_s: expected more than the 1"));
  CHECK_THAT(text, Contains("/key_frames/1/eye_m: unknown key"));
  CHECK_THAT(text, Contains("/key_frames/2: \"time_s\" is missing"));
  CHECK_THAT(text, Contains("/key_frames/3/eye_m: expected an array of 3"));
  CHECK_THAT(text, Contains("/key_frames/4/eye_m: the eye at 0, 0, 1 m is inside the vehicle"));
  CHECK_THAT(text, Contains("/key_frames/4/field_of_view_deg: expected 1 to 150 degrees, got 200"));
  CHECK_THAT(text, Contains("/key_frames/5: expected \"preset\", or \"eye_m\" and \"target_m\""));
  CHECK_THAT(text, Contains("/key_frames/6: \"target_m\" is missing"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 10);
}

TEST_CASE("a path file without key frames, or none at all, is refused") {
  CHECK_THAT(faults(R"({"key_frames": []})"), Contains("at least one key frame"));
  CHECK_THAT(faults(R"({})"), Contains("\"key_frames\" is missing"));
  CHECK_THAT(faults("[1]"), Contains("expected an object"));
  CHECK_THAT(faults("{"), Contains("way.json:1"));
}
