// What stands on the bowl's surface is shown where it stands: measured on rendered pictures of a world in
// which posts and boxes mark places of the wall.

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/bowl/viewpoint_lut.h"
#include "algorithms/bowl/viewpoint_presets.h"
#include "algorithms/scene/renderer.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/synthesis/synthesize.h"
#include "tests/catch.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::bowl;
using namespace svchain::testing;

namespace {

const Eigen::Vector2i kPicture(880, 1080);
constexpr double kMark_m = 0.12;  // height of a mark's visible band, its middle on the surface
const scene::Colour kGreen{20, 250, 20}, kDark{20, 20, 20};

/// Places all around, low and high on the wall.
std::vector<Eigen::Vector3d> marks_on(const BowlSurface& surface) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 28; ++i) {
    const double angle = 2 * M_PI * (i + 0.3) / 28, share = 0.35 + 0.1 * (i % 3);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d rim = surface.rim_towards(direction);
    double from = 0, to = 1;  // of the way to the rim, where that share of the wall is reached
    while (to - from > 1e-6) {
      const double middle = (from + to) / 2;
      (surface.distance_from_floor(middle * rim) < share * surface.rise_m ? from : to) = middle;
    }
    const Eigen::Vector2d ground = from * rim;
    places.emplace_back(ground.x(), ground.y(), surface.height_at(ground));
  }
  return places;
}

/// A green band about the place, on something dark and a little thicker that reaches up to it.
void add_mark(scene::Scene& scene, const Eigen::Vector3d& place, bool round) {
  const double top = place.z() + kMark_m / 2, bottom = place.z() - kMark_m / 2;
  if (round) {
    scene.posts.push_back({place.head<2>(), 0.05, top, kGreen});
    scene.posts.push_back({place.head<2>(), 0.07, bottom, kDark});
  } else {
    const double yaw = std::atan2(place.y(), place.x());
    scene.boxes.push_back({{place.x(), place.y(), yaw}, {0.08, 0.1, top}, kGreen});
    scene.boxes.push_back({{place.x(), place.y(), yaw}, {0.12, 0.14, bottom}, kDark});
  }
}

/// The middle of the green within 20 px; nothing where there is hardly any.
std::optional<Eigen::Vector2d> green_near(const cv::Mat& picture, const Eigen::Vector2d& expected) {
  Eigen::Vector2d sum(0, 0);
  double mass = 0;
  for (int y = int(expected.y()) - 20; y <= int(expected.y()) + 20; ++y)
    for (int x = int(expected.x()) - 20; x <= int(expected.x()) + 20; ++x) {
      if (x < 0 || y < 0 || x >= picture.cols || y >= picture.rows) return std::nullopt;
      const auto& p = picture.at<cv::Vec3b>(y, x);
      const double green = p[1] - std::max(p[0], p[2]) - 40.0;
      if (green <= 0) continue;
      sum += green * Eigen::Vector2d(x, y);
      mass += green;
    }
  if (mass < 500) return std::nullopt;
  return sum / mass;
}

struct MarkedWorld {
  MarkedWorld() {
    auto read = scene::read_scene(project_folder() / "configs" / "scenes" / "parking.json");
    REQUIRE(read);
    scene::Scene scene = *read;
    scene.boxes.clear();
    scene.posts.clear();
    scene.paint.clear();  // nothing else is green
    for (scene::Response& response : scene.responses) response = {};
    rig = scene.rig;
    surface = default_surface(rig.vehicle);
    marks = marks_on(surface);
    for (size_t i = 0; i < marks.size(); ++i) add_mark(scene, marks[i], i % 2 == 0);
    const scene::Renderer renderer(std::make_shared<scene::World>(scene));
    for (size_t c = 0; c < 4; ++c) {
      renderer.render(c, 0, 0, memory[c]);
      frames[c] = colour::bgr_picture(memory[c]);
    }
  }

  cv::Mat seen_from(const Viewpoint& viewpoint) const {
    std::vector<std::byte> bytes(ViewpointLut::capacity(kPicture));
    ViewpointLut maker(rig, surface, {});
    const size_t used = maker.build(viewpoint, kPicture, bytes);
    cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
    synthesize(synthesis::GeometricLut(std::span(bytes).first(used)), frames,
               synthesis::ToneMapping::identity(), colour::bgr_picture(picture), nullptr);
    return picture;
  }

  geometry::Rig rig;
  BowlSurface surface;
  std::vector<Eigen::Vector3d> marks;
  std::array<cv::Mat, 4> memory;
  std::array<colour::Picture, 4> frames;
};

}  // namespace

TEST_CASE("posts and boxes on the bowl's surface are shown where they stand, to a pixel") {
  const MarkedWorld world;
  double sum_px = 0;
  int found = 0;
  std::vector<Viewpoint> viewpoints;
  for (const char* name : {"top", "chase", "front", "left", "right"})
    viewpoints.push_back(*preset(name, world.rig.vehicle, world.surface));
  for (double angle = 0; angle < 6; angle += M_PI / 4)  // from above the car outwards
    viewpoints.push_back({{0, 0, 4}, {7 * std::cos(angle), 7 * std::sin(angle), 0.5}, {0, 0, 1}, 70});
  for (const Viewpoint& viewpoint : viewpoints) {
    const cv::Mat picture = world.seen_from(viewpoint);
    const Perspective perspective(viewpoint, kPicture);
    for (const Eigen::Vector3d& mark : world.marks) {
      const auto expected = perspective.project(mark);
      if (!expected) continue;
      const auto seen = green_near(picture, *expected);
      if (!seen) continue;
      CAPTURE(viewpoint.eye_m.transpose(), mark.transpose(), expected->transpose(), seen->transpose());
      CHECK((*seen - *expected).norm() < 4);
      sum_px += (*seen - *expected).norm();
      ++found;
    }
  }
  CAPTURE(found);
  REQUIRE(found >= 40);
  CAPTURE(sum_px / found);
  CHECK(sum_px / found <= 1);
}
