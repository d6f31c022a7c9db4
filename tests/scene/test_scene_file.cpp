#include <fstream>

#include "algorithms/scene/scene_file.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;

namespace {

/// A text as if it lay among the shipped scenes.
Result<scene::Scene> parsed(const std::string& text) {
  return scene::parse_scene(text, (testing::project_folder() / "configs" / "scenes" / "given.json").string());
}

std::vector<std::string> pointers(const Faults& faults) {
  std::vector<std::string> list;
  for (const auto& fault : faults) list.push_back(fault.pointer);
  return list;
}

}  // namespace

TEST_CASE("a scene of nothing but a rig is a bare ground under a sky") {
  const auto scene = parsed(R"({"rig": "../rigs/car.json"})");
  REQUIRE(scene);
  CHECK(scene->rig.cameras.size() == 4);
  CHECK(scene->paint.empty());
  CHECK(scene->path.travel_m == 0);
  CHECK(scene->responses[3].gamma == 1);
}

TEST_CASE("a scene file's numbers arrive where they belong") {
  const auto scene = parsed(
      R"({"rig": "../rigs/car.json", "seed": 5, "nominal": {"position_m": 0.1, "rotation_deg": 2}, "frame_rate_hz": 25, "timestamp_jitter_ms": 4,
    "path": {"travel_m": 1, "period_s": 6, "turn_radius_m": 9},
    "ground": {"colour_bgr": [1, 2, 3], "metres_per_texel": 0.01, "half_extent_m": 5},
    "paint": [{"type": "zebra", "pose": {"x_m": 1, "y_m": 2}, "length_m": 2, "width_m": 5, "bars": 3, "colour_bgr": [9, 8, 7]}],
    "charts": [{"name": "a", "type": "checkerboard", "squares": [5, 4], "square_m": 0.25, "pose": {"x_m": 3, "y_m": 1, "yaw_deg": 90}}],
    "boxes": [{"pose": {"x_m": 4, "y_m": 1, "yaw_deg": 90}, "size_m": [1, 2, 3], "colour_bgr": [7, 8, 9]}],
    "posts": [{"place_m": [5, 6], "radius_m": 0.1, "height_m": 1.5, "colour_bgr": [1, 2, 3]}],
    "cameras": {"rear": {"gain_bgr": [0.9, 1, 1.1], "gamma": 1.1, "falloff": [0.2, 0.1], "noise_sigma": 2}}})");
  REQUIRE(scene);
  CHECK(scene->seed == 5);
  CHECK(scene->nominal.position_m == 0.1);
  CHECK(scene->nominal.rotation_deg == 2);
  CHECK(scene->frame_rate_hz == 25);
  CHECK(scene->path.turn_radius_m == 9);
  CHECK(scene->ground.colour.r == 3);
  REQUIRE(scene->paint.size() == 3);
  CHECK(scene->paint[0].colour.b == 9);
  REQUIRE(scene->boxes.size() == 1);
  CHECK(scene->boxes[0].world_from_box.yaw_rad == Approx(1.5707963));
  CHECK(scene->boxes[0].size_m.z() == 3);
  REQUIRE(scene->posts.size() == 1);
  CHECK(scene->posts[0].place_m.y() == 6);
  CHECK(scene->posts[0].height_m == 1.5);
  CHECK(scene->posts[0].colour.r == 3);
  REQUIRE(scene->charts.size() == 1);
  CHECK(scene->charts[0].corner(5, 2).x() == Approx(3));
  CHECK(scene->charts[0].corner(5, 2).y() == Approx(1.625));
  CHECK(scene->responses[2].gain_bgr[2] == 1.1);
  CHECK(scene->responses[2].falloff[0] == 0.2);
  CHECK(scene->responses[0].noise_sigma == 0);
}

TEST_CASE("every fault of a scene file is reported at once with its place") {
  const auto scene = parsed(R"({"rig": "../rigs/car.json",
    "grund": {},
    "paint": [
      {"type": "zebro", "colour_bgr": [0, 0, 0]},
      {"type": "disc", "pose": {"x_m": 1}, "radius_m": -1, "colour_bgr": [0, 0, 300]}],
    "charts": [{"name": "a", "type": "checkerboard", "squares": [5], "square_m": 0.25, "pose": {"x_m": 3, "y_m": 1}}],
    "cameras": {"back": {}, "front": {"gamma": 0}}})");
  REQUIRE_FALSE(scene);
  const std::vector<std::string> expected = {
      "/paint/0/type",         "/paint/1/pose", "/paint/1/radius_m",    "/charts/0/squares",
      "/paint/1/colour_bgr/2", "/cameras/back", "/cameras/front/gamma", "/grund"};
  auto found = pointers(scene.error());
  for (const auto& pointer : expected) {
    INFO(pointer);
    CHECK(std::count(found.begin(), found.end(), pointer) == 1);
  }
  CHECK(found.size() == expected.size());
  for (const auto& fault : scene.error()) {
    if (fault.pointer == "/paint/0/type") {
      CHECK(fault.where.line == 4);
      CHECK(fault.message.find("did you mean \"zebra\"") != std::string::npos);
    }
    if (fault.pointer == "/grund") CHECK(fault.message.find("did you mean \"ground\"") != std::string::npos);
  }
}

TEST_CASE("a scene whose rig is missing or faulty names both files") {
  const auto missing = parsed(R"({"rig": "../rigs/carr.json"})");
  REQUIRE_FALSE(missing);
  CHECK(missing.error()[0].pointer == "/rig");
  CHECK(missing.error().size() >= 2);

  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "rig.json")
      << R"({"vehicle": {"length_m": 4.8, "width_m": "wide"}, "cameras": {}})";
  std::ofstream(folder.path() / "scene.json") << R"({"rig": "rig.json", "sed": 1})";
  const auto faulty = scene::read_scene(folder.path() / "scene.json");
  REQUIRE_FALSE(faulty);
  const auto found = pointers(faulty.error());
  CHECK(std::count(found.begin(), found.end(), "/vehicle/width_m") == 1);
  CHECK(std::count(found.begin(), found.end(), "/sed") == 1);
}

TEST_CASE("a scene is refused where its numbers do not go together") {
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "path": {"travel_m": 3, "turn_radius_m": 2}})"));
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "boxes": [{"pose": {"x_m": 4, "y_m": 1}}]})"));
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "posts": [{"place_m": [1, 2, 3], "radius_m": 0}]})"));
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "nominal": {"rotation_deg": -1}})"));
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "ground": {"half_extent_m": 3}})"));
  CHECK_FALSE(
      parsed(R"({"rig": "../rigs/car.json", "ground": {"half_extent_m": 30, "metres_per_texel": 0.001}})"));
  CHECK_FALSE(parsed(R"({"rig": "../rigs/car.json", "frame_rate_hz": 100, "timestamp_jitter_ms": 5})"));
}
