#include "algorithms/geometry/view.h"
#include "algorithms/scene/scene_file.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;

namespace {

scene::Scene shipped(const std::string& name) {
  const auto scene = scene::read_scene(testing::project_folder() / "configs" / "scenes" / (name + ".json"));
  if (!scene) {
    for (const auto& fault : scene.error()) UNSCOPED_INFO(fault.text());
  }
  REQUIRE(scene);
  return *scene;
}

int cameras_that_see(const geometry::Rig& rig, const Eigen::Vector2d& place) {
  int count = 0;
  for (const auto& camera : rig.cameras) count += camera.see({place.x(), place.y(), 0}).has_value();
  return count;
}

}  // namespace

TEST_CASE("the shipped rigs see the whole view around the vehicle, its corners with two cameras") {
  for (const std::string name : {"parking", "toy"}) {
    const geometry::Rig rig = shipped(name).rig;
    const Eigen::Vector2d half(rig.vehicle.length_m / 2, rig.vehicle.width_m / 2);
    geometry::View view;
    view.metres_per_px = geometry::default_metres_per_px(rig.vehicle, view.size_px);
    int unseen = 0;
    int corners_seen_once = 0;
    for (int j = 0; j < view.size_px.y(); j += 3) {
      for (int i = 0; i < view.size_px.x(); i += 3) {
        const Eigen::Vector2d place = view.ground_from_pixel({i, j});
        const bool beside = std::abs(place.y()) > half.y();
        const bool ahead = std::abs(place.x()) > half.x();
        const int seeing = cameras_that_see(rig, place);
        unseen += (beside || ahead) && seeing == 0;
        corners_seen_once += beside && ahead && seeing < 2;
      }
    }
    INFO(name);
    CHECK(unseen == 0);
    CHECK(corners_seen_once == 0);
  }
}

TEST_CASE("every chart of the shipped scenes lies where two cameras see all of it") {
  for (const std::string name : {"parking", "toy"}) {
    const scene::Scene scene = shipped(name);
    CHECK(scene.charts.size() == 4);
    for (const auto& board : scene.charts) {
      for (const int i : {0, board.squares[0]}) {
        for (const int j : {0, board.squares[1]}) {
          INFO(name << ' ' << board.name << ' ' << i << ' ' << j);
          CHECK(cameras_that_see(scene.rig, board.corner(i, j)) >= 2);
        }
      }
    }
  }
}
