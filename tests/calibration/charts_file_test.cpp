// Charts files: read strictly, told faults of all at once, and written so that they are read as they were.

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/scene_charts.h"
#include "algorithms/geometry/angles.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::calibration;
using Catch::Matchers::Contains;

namespace {

const char* const kAllTypes = R"({"charts":[
 {"name":"front_left","type":"checkerboard","squares":[5,4],"square_m":0.25,"pose":{"x_m":3.1,"y_m":1.6,"yaw_deg":30}},
 {"name":"mat","type":"squares","side_m":0.8,"centres_m":[[0,0],[1.6,0]]},
 {"name":"carpet","type":"apriltag_36h11","tag_m":0.4,"tags":[{"id":0,"x_m":0,"y_m":0},{"id":7,"x_m":-1,"y_m":0.5}]}]}
)";

/// What a file with these charts is refused with, a line for each fault.
std::string faults_of(const std::string& charts) {
  const auto read = parse_charts("{\"charts\": [" + charts + "]}", "c.json");
  if (read) return "read";
  std::string text;
  for (const auto& fault : read.error()) text += fault.text() + "\n";
  return text;
}

std::string board(const std::string& name) {
  return R"({"name":")" + name + R"(","type":"checkerboard","squares":[5,4],"square_m":0.25})";
}

std::string mat(const std::string& centres) {
  return R"({"name":"mat","type":"squares","side_m":0.4,"centres_m":[)" + centres + "]}";
}

std::string tags(const std::string& name, const std::string& list) {
  return R"({"name":")" + name + R"(","type":"apriltag_36h11","tag_m":0.4,"tags":[)" + list + "]}";
}

}  // namespace

TEST_CASE("charts of every type are read") {
  const auto charts = parse_charts(kAllTypes, "c.json");
  REQUIRE(charts);
  REQUIRE(charts->size() == 3);
  const auto& [front_left, mat, carpet] = std::tie((*charts)[0], (*charts)[1], (*charts)[2]);
  CHECK(front_left.name == "front_left");
  CHECK(front_left.type == ChartType::kCheckerboard);
  CHECK(front_left.squares == std::array{5, 4});
  CHECK(front_left.side_m == 0.25);
  REQUIRE(front_left.vehicle_from_chart);
  CHECK(front_left.vehicle_from_chart->x_m == 3.1);
  CHECK(front_left.vehicle_from_chart->y_m == 1.6);
  CHECK(front_left.vehicle_from_chart->yaw_rad == Approx(geometry::radians(30)));
  CHECK(mat.type == ChartType::kSquares);
  CHECK(mat.side_m == 0.8);
  REQUIRE(mat.centres_m.size() == 2);
  CHECK(mat.centres_m[1] == Eigen::Vector2d(1.6, 0));
  CHECK_FALSE(mat.vehicle_from_chart);
  CHECK(carpet.type == ChartType::kAprilTag36h11);
  CHECK(carpet.side_m == 0.4);
  REQUIRE(carpet.tags.size() == 2);
  CHECK(carpet.tags[1].id == 7);
  CHECK(carpet.tags[1].place_m == Eigen::Vector2d(-1, 0.5));
}

TEST_CASE("charts are written so that they are read as they were") {
  const auto charts = parse_charts(kAllTypes, "c.json");
  REQUIRE(charts);
  const std::string text = charts_text(*charts);
  const auto again = parse_charts(text, "c.json");
  REQUIRE(again);
  CHECK(charts_text(*again) == text);
  CHECK(again->size() == 3);
  CHECK_THAT(text, Contains(R"("square_m":0.25,"pose":{"x_m":3.1,"y_m":1.6,"yaw_deg":30.0})"));
  CHECK_THAT(text, Contains(R"("centres_m":[[0.0,0.0],[1.6,0.0]])"));
  CHECK_THAT(text, Contains(R"({"id":7,"x_m":-1.0,"y_m":0.5})"));
}

TEST_CASE("degrees are the same after rewriting") {
  for (const char* yaw : {"0.0", "30.0", "-90.0", "33.3", "123.456789", "-0.1", "359.99", "1e-07"}) {
    const auto charts =
        parse_charts(R"({"charts":[{"name":"b","type":"checkerboard","squares":[2,3],"square_m":1,"pose":)"
                     R"({"x_m":0,"y_m":0,"yaw_deg":)" +
                         std::string(yaw) + "}}]}",
                     "c.json");
    REQUIRE(charts);
    CHECK_THAT(charts_text(*charts), Contains("\"yaw_deg\":" + std::string(yaw) + "}"));
  }
}

TEST_CASE(
    "an angle that the calibration has found is the same after writing and reading to the last bit or two") {
  Chart found;
  found.name = "found";
  found.squares = {5, 4};
  found.side_m = 0.25;
  found.vehicle_from_chart = geometry::Pose2{1, 2, 0.7853981};
  const auto read = parse_charts(charts_text({found}), "c.json");
  REQUIRE(read);
  CHECK(std::abs(read->front().vehicle_from_chart->yaw_rad - 0.7853981) < 1e-15);
}

TEST_CASE("what svchain simulate says of its charts is a charts file") {
  scene::Checkerboard simulated;
  simulated.name = "front_left";
  simulated.squares = {5, 4};
  simulated.square_m = 0.25;
  simulated.world_from_chart = {3.1, 1.6, geometry::radians(6)};
  scene::Scene scene;
  scene.charts = {simulated};
  const std::string text = charts_text(charts_of(scene));
  const auto read = parse_charts(text, "charts.json");
  REQUIRE(read);
  REQUIRE(read->size() == 1);
  CHECK(read->front().name == "front_left");
  CHECK(read->front().squares == std::array{5, 4});
  CHECK(read->front().vehicle_from_chart->yaw_rad == Approx(geometry::radians(6)));
  CHECK(charts_text(*read) == text);
}

TEST_CASE("all faults of a charts file are told at once, each with its place") {
  const auto read = parse_charts(R"({"charts": [
  {"name": "a", "type": "checkerboard", "squares": [5, 1], "square_m": -1, "pose": {"x_m": 200, "y_m": 0}},
  {"name": "", "type": "sqares", "side_m": 1},
  {"type": "squares", "side_m": 0, "centers_m": []},
  {"name": "d", "type": "apriltag_36h11", "tag_m": "wide", "tags": [{"id": 587, "x_m": 0, "y_m": 0}]},
  5]})",
                                 "c.json");
  REQUIRE_FALSE(read);
  std::vector<std::string> said;
  for (const auto& fault : read.error()) said.push_back(fault.text());
  const std::vector<std::string> expected = {
      "c.json:2:56: error: /charts/0/squares/1: expected 2 to 100, got 1",
      "c.json:2:72: error: /charts/0/square_m: expected 0 to 10 m, got -1",
      "c.json:2:92: error: /charts/0/pose/x_m: expected -100 to 100 m, got 200",
      "c.json:2:84: error: /charts/0/pose: \"yaw_deg\" is missing",
      "c.json:3:12: error: /charts/1/name: expected a name",
      "c.json:3:24: error: /charts/1/type: expected checkerboard, squares or apriltag_36h11, got \"sqares\", "
      "did "
      "you mean \"squares\"?",
      "c.json:4:3: error: /charts/2: \"name\" is missing",
      "c.json:4:33: error: /charts/2/side_m: expected more than 0 m",
      "c.json:4:49: error: /charts/2/centers_m: unknown key, did you mean \"centres_m\"? (known: name, type, "
      "side_m, centres_m or pose)",
      "c.json:4:3: error: /charts/2: \"centres_m\" is missing",
      "c.json:5:52: error: /charts/3/tag_m: expected a number, got \"wide\"",
      "c.json:5:76: error: /charts/3/tags/0/id: expected 0 to 586, got 587",
      "c.json:6:3: error: /charts/4: expected an object, got 5"};
  std::vector<std::string> missing;
  for (const auto& line : expected) {
    if (std::find(said.begin(), said.end(), line) == said.end()) missing.push_back(line);
  }
  INFO("said:\n" << Catch::StringMaker<std::vector<std::string>>::convert(said));
  CHECK(missing == std::vector<std::string>{});
  CHECK(said.size() == expected.size());
}

TEST_CASE("a file without charts, squares or tags is refused") {
  CHECK_THAT(faults_of(""), Contains("/charts: expected at least one chart"));
  CHECK_THAT(faults_of(mat("")), Contains("/charts/0/centres_m: expected at least one square"));
  CHECK_THAT(faults_of(tags("t", "")), Contains("/charts/0/tags: expected at least one tag"));
  CHECK_FALSE(parse_charts("{}", "c.json"));
  CHECK_FALSE(parse_charts("[]", "c.json"));
  CHECK_FALSE(read_charts("/nowhere/charts.json"));
}

TEST_CASE("two charts of one name, and one tag in two places, are refused") {
  CHECK_THAT(faults_of(board("a") + "," + board("b") + "," + board("a")),
             Contains("/charts/2/name: \"a\" is another chart's name already"));
  const std::string three = R"({"id":3,"x_m":0,"y_m":0})";
  CHECK_THAT(faults_of(tags("a", three) + "," + tags("b", three)),
             Contains("/charts/1/tags/0/id: tag 3 is in this file already"));
  CHECK_THAT(faults_of(tags("a", three + R"(,{"id":3,"x_m":2,"y_m":0})")),
             Contains("/charts/0/tags/1/id: tag 3 is in this file already"));
}

TEST_CASE("squares may touch at their corners, but neither overlap nor share an edge") {
  CHECK(faults_of(mat("[0,0],[0.4,0.4],[0.8,0],[2,2]")) == "read");
  CHECK_THAT(faults_of(mat("[0,0],[1,1],[0.3,0.1]")), Contains("/charts/0/centres_m/2: overlaps square 0"));
  CHECK_THAT(faults_of(mat("[0,0],[0,0]")), Contains("/charts/0/centres_m/1: overlaps square 0"));
  CHECK_THAT(faults_of(mat("[0,0],[0.4,0]")),
             Contains("/charts/0/centres_m/1: shares an edge with square 0"));
  CHECK_THAT(faults_of(mat("[0,0],[0.1,-0.4]")), Contains("shares an edge with square 0"));
}

TEST_CASE("tags have white all around") {
  const auto second = [](const std::string& x, const std::string& y) {
    return faults_of(tags("t", R"({"id":0,"x_m":0,"y_m":0},{"id":1,"x_m":)" + x + R"(,"y_m":)" + y + "}"));
  };
  CHECK(second("0.5", "0.5") == "read");
  CHECK_THAT(second("0.4", "0.4"), Contains("/charts/0/tags/1: touches tag 0, expected white all around"));
  CHECK_THAT(second("0.2", "0"), Contains("overlaps tag 0"));
}

TEST_CASE("the carpet of the real car lies on its grid of 40 cm") {
  const auto charts = read_charts(testing::project_folder() / "configs" / "charts" / "car_carpet.json");
  REQUIRE(charts);
  CHECK(charts->front().centres_m.size() == 80);
  for (const auto& corner : corners(charts->front())) {
    const Eigen::Array2d steps = (Eigen::Array2d(5, 3) - corner.place_m.array()) / 0.4;
    CHECK((steps - steps.round()).abs().maxCoeff() < 1e-9);
    CHECK(steps.minCoeff() > -1e-9);
  }
}
