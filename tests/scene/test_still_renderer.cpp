#include <opencv2/imgproc.hpp>

#include "algorithms/scene/renderer.h"
#include "algorithms/scene/shapes.h"
#include "algorithms/scene/still_renderer.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::scene;

namespace {

StillRenderer stills_of(const Scene& scene) {
  return StillRenderer(std::make_shared<const World>(scene));
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// The vehicle turned and elsewhere, paint all around, cameras that answer unlike each other.
Scene lively_scene() {
  Scene scene = testing::small_scene();
  scene.path = {0.8, 6, 5};
  for (double x = -3; x <= 3; x += 1.5) {
    scene.paint.push_back({disc({x, 2, 0}, 0.4), {40, 90, 220}, 1});
    scene.paint.push_back({rectangle({3.4, x, 0.4}, 0.7, 0.5), {230, 230, 230}, 1});
    scene.paint.push_back({rectangle({-3.4, x, 0.4}, 0.7, 0.5), {20, 40, 20}, 1});
  }
  scene.responses[0].gain_bgr = {0.8, 1, 1.1};
  scene.responses[1].gamma = 1.2;
  scene.responses[2].falloff = {0.3, 0.1};
  return scene;
}

}  // namespace

TEST_CASE("still pictures show what the live ones show, wherever the vehicle is") {
  const auto world = std::make_shared<const World>(lively_scene());
  const Renderer live(world);
  const StillRenderer still(world);
  cv::Mat quick;
  for (size_t camera = 0; camera < 4; ++camera) {
    live.render(camera, 1.1, 0, quick);
    cv::Mat fine = still.render(camera, 1.1, 0);
    const cv::Mat lit = (cv::Mat)(quick.reshape(1) > 0);
    CHECK(cv::countNonZero(lit) > 100000);
    cv::GaussianBlur(quick, quick, {0, 0}, 1.5);
    cv::GaussianBlur(fine, fine, {0, 0}, 1.5);
    INFO(geometry::kCameraNames[camera]);
    CHECK(cv::norm(quick, fine, cv::NORM_L1) / static_cast<double>(quick.total() * 3) < 1.0);
  }
}

TEST_CASE("in a still picture a chart's corners lie where the lens puts them, to a twentieth of a pixel") {
  Scene scene = testing::small_scene(1280);
  scene.ground.metres_per_texel = 0.005;
  scene.charts.push_back({"front_left", {5, 4}, 0.3, {3.4, 1.2, 0.2}});
  scene.charts.push_back({"front_right", {5, 4}, 0.3, {3.3, -1.3, -0.4}});
  cv::Mat grey;
  cv::cvtColor(stills_of(scene).render(0, 0, 0), grey, cv::COLOR_BGR2GRAY);
  double squares = 0;
  int count = 0;
  for (const auto& board : scene.charts) {
    for (int i = 1; i < board.squares[0]; ++i) {
      for (int j = 1; j < board.squares[1]; ++j, ++count) {
        const Eigen::Vector2d place = board.corner(i, j);
        const auto expected = scene.rig.cameras[0].see({place.x(), place.y(), 0});
        REQUIRE(expected);
        std::vector<cv::Point2f> corner = {{float(expected->x()) + 0.3f, float(expected->y()) - 0.3f}};
        cv::cornerSubPix(grey, corner, {4, 4}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-4});
        squares += std::pow(corner[0].x - expected->x(), 2) + std::pow(corner[0].y - expected->y(), 2);
      }
    }
  }
  CHECK(count == 24);
  CAPTURE(std::sqrt(squares / count));
  CHECK(std::sqrt(squares / count) < 0.06);
}

TEST_CASE("the same camera, time and frame give the same still picture, another frame other noise") {
  Scene scene = testing::small_scene();
  scene.ground.grain_contrast = 0.1;
  for (auto& response : scene.responses) response.noise_sigma = 3;
  const StillRenderer renderer = stills_of(scene);
  const cv::Mat picture = renderer.render(1, 0, 4);
  CHECK(same(picture, renderer.render(1, 0, 4)));
  CHECK(same(picture, stills_of(scene).render(1, 0, 4)));
  cv::Mat difference;
  cv::subtract(picture, renderer.render(1, 0, 5), difference, cv::noArray(), CV_32F);
  cv::Scalar mean, deviation;
  cv::meanStdDev(difference(cv::Rect(110, 120, 100, 60)), mean, deviation);
  CHECK(deviation[1] == Approx(3 * std::sqrt(2)).margin(0.3));
}

TEST_CASE("beyond the lens a still picture is black, above the horizon it is sky") {
  Scene scene = testing::small_scene();
  for (auto& response : scene.responses) response.noise_sigma = 3;
  const cv::Mat picture = stills_of(scene).render(0, 0, 0);
  CHECK(picture.at<cv::Vec3b>(0, 0) == cv::Vec3b(0, 0, 0));
  CHECK(picture.at<cv::Vec3b>(179, 319) == cv::Vec3b(0, 0, 0));
  CHECK(picture.at<cv::Vec3b>(5, 160)[0] > 150);
}
