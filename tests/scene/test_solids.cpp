#include <opencv2/imgproc.hpp>

#include "algorithms/scene/renderer.h"
#include "algorithms/scene/solids.h"
#include "algorithms/scene/still_renderer.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::scene;
using Eigen::Vector3d;

namespace {

constexpr Colour kRed{0, 0, 250};
constexpr Colour kBlue{250, 0, 0};

/// All around the vehicle and on its way, some hidden by others.
Scene full_scene() {
  Scene scene = testing::small_scene();
  scene.boxes = {{{4.5, 0.8, 0.5}, {0.8, 0.5, 0.6}, kRed},
                 {{6.5, 1.0, 0.2}, {1, 1, 1.5}, kBlue},
                 {{-0.5, 3, 1}, {2, 0.6, 1.2}, kRed},
                 {{-5, -1, 0}, {1.5, 3, 2.5}, kBlue}};
  scene.posts = {{{3.6, -1.2}, 0.1, 1.1, kBlue}, {{1, -2.5}, 0.3, 0.4, kRed}, {{-3.5, 1.4}, 0.05, 3, kRed}};
  return scene;
}

cv::Mat live(const Scene& scene, size_t camera, double time_s = 0) {
  cv::Mat image;
  Renderer(std::make_shared<const World>(scene)).render(camera, time_s, 0, image);
  return image;
}

cv::Vec3b at(const cv::Mat& image, const Scene& scene, size_t camera, const Vector3d& place) {
  const auto pixel = scene.rig.cameras[camera].see(place);
  REQUIRE(pixel);
  return image.at<cv::Vec3b>(static_cast<int>(std::lround(pixel->y())),
                             static_cast<int>(std::lround(pixel->x())));
}

bool is_red(const cv::Vec3b& bgr) {
  return bgr[2] > 150 && bgr[0] < 20 && bgr[1] < 20;
}

}  // namespace

TEST_CASE("a ray that meets a box sees the face it enters by, brighter the more it looks up") {
  Scene scene;
  scene.boxes = {{{5, 0, 0}, {2, 2, 1}, {200, 200, 200}}};
  const Solids solids(scene);
  const auto front = solids.first_seen({0, 0, 0.5}, Vector3d::UnitX());
  const auto top = solids.first_seen({5, 0, 3}, -Vector3d::UnitZ());
  REQUIRE((front && top));
  CHECK((*front)[0] < (*top)[0]);
  CHECK((*top)[0] <= 200);
  CHECK_FALSE(solids.first_seen({0, 0, 1.01}, Vector3d::UnitX()));
  CHECK_FALSE(solids.first_seen({0, 1.01, 0.5}, Vector3d::UnitX()));
  CHECK_FALSE(solids.first_seen({0, 0, 0.5}, -Vector3d::UnitX()));
}

TEST_CASE("a box stands turned as its pose says") {
  Scene scene;
  scene.boxes = {{{5, 0, 3.14159265 / 4}, {2, 2, 1}, kRed}};
  const Solids solids(scene);
  CHECK(solids.first_seen({5, 1.4, 3}, -Vector3d::UnitZ()));
  CHECK_FALSE(solids.first_seen({5.9, 0.9, 3}, -Vector3d::UnitZ()));
}

TEST_CASE("a post is round and ends at its height") {
  Scene scene;
  scene.posts = {{{4, 1}, 0.5, 2, kRed}};
  const Solids solids(scene);
  CHECK(solids.first_seen({0, 1.49, 1}, Vector3d::UnitX()));
  CHECK_FALSE(solids.first_seen({0, 1.51, 1}, Vector3d::UnitX()));
  CHECK_FALSE(solids.first_seen({0, 1, 2.01}, Vector3d::UnitX()));
  CHECK(solids.first_seen({4.4, 1, 3}, -Vector3d::UnitZ()));
  CHECK_FALSE(solids.first_seen({4.4, 1.4, 3}, -Vector3d::UnitZ()));
  CHECK(solids.first_seen({0, 1, 3}, Vector3d(3.8, 0, -1).normalized()));
}

TEST_CASE("of two things on a ray the nearer one is seen, whichever comes first in the file") {
  Scene scene;
  scene.boxes = {{{8, 0, 0}, {1, 1, 1}, kBlue}, {{4, 0, 0}, {1, 1, 1}, kRed}};
  scene.posts = {{{6, 0}, 0.5, 1, kBlue}};
  const auto seen = Solids(scene).first_seen({0, 0, 0.5}, Vector3d::UnitX());
  REQUIRE(seen);
  CHECK((*seen)[0] == 0);
  CHECK((*seen)[2] > 100);
}

TEST_CASE(
    "what stands hides the ground behind it, in live and in still pictures, and moves as the ground does") {
  Scene scene = testing::small_scene(640);
  scene.path = {1, 8, 1000};
  scene.posts = {{{5, 0}, 0.2, 1, kRed}};
  const StillRenderer still(std::make_shared<const World>(scene));
  for (const double time_s : {0.0, 2.0, 6.0}) {
    const double ahead = 5 - std::sin(2 * 3.14159265358979 * time_s / 8);
    INFO(time_s);
    for (const cv::Mat& image : {live(scene, 0, time_s), still.render(0, time_s, 0)}) {
      CHECK(is_red(at(image, scene, 0, {ahead - 0.2, 0, 0.05})));
      CHECK(is_red(at(image, scene, 0, {ahead - 0.2, 0, 0.9})));
      CHECK_FALSE(is_red(at(image, scene, 0, {ahead - 0.2, 0, 1.1})));
      CHECK_FALSE(is_red(at(image, scene, 0, {ahead - 0.5, 0, 0})));
      CHECK_FALSE(is_red(at(image, scene, 0, {ahead, 0.4, 0.4})));
    }
  }
}

TEST_CASE("live and still pictures agree about what stands, but for its edges") {
  Scene scene = full_scene();
  scene.path = {0.8, 6, 5};
  const StillRenderer still(std::make_shared<const World>(scene));
  for (size_t camera = 0; camera < 4; ++camera) {
    for (const double time_s : {0.0, 1.2}) {
      const cv::Mat quick = live(scene, camera, time_s);
      cv::Mat difference;
      cv::absdiff(quick, still.render(camera, time_s, 0), difference);
      const int unlike = cv::countNonZero(difference.reshape(1) > 40);
      cv::Mat coloured;
      cv::inRange(quick, cv::Scalar(0, 0, 150), cv::Scalar(20, 20, 255), coloured);
      cv::Mat blue;
      cv::inRange(quick, cv::Scalar(150, 0, 0), cv::Scalar(255, 20, 20), blue);
      INFO(geometry::kCameraNames[camera] << " " << time_s);
      CHECK(cv::countNonZero(coloured | blue) > 300);
      CHECK(unlike < 2 * 3 * 320 * 180 / 100);
    }
  }
}

TEST_CASE("runs that are passed over have nothing in them: every pixel is what its own ray sees") {
  Scene scene = full_scene();
  const Solids solids(scene);
  for (size_t c = 0; c < 4; ++c) {
    const geometry::Camera& camera = scene.rig.cameras[c];
    const cv::Mat image = live(scene, c);
    int wrong = 0, hits = 0;
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const auto ray = camera.lens->unproject({double(x), double(y)});
        if (!ray) continue;
        const auto seen = solids.first_seen(camera.vehicle_from_camera.translation,
                                            camera.vehicle_from_camera.rotation * *ray);
        const auto& pixel = image.at<cv::Vec3b>(y, x);
        const bool shown = pixel[1] == 0 && pixel[0] + pixel[2] > 150;
        wrong += shown != seen.has_value();
        hits += seen.has_value();
      }
    }
    INFO(camera.name);
    CHECK(hits > 100);
    CHECK(wrong <= hits / 200);  // rays that graze an edge, rounded to floats
  }
}

TEST_CASE("rendering a frame with things in it allocates nothing") {
  const Renderer renderer(std::make_shared<const World>(full_scene()));
  cv::Mat image(180, 320, CV_8UC3);
  const size_t before = testing::allocation_count();
  for (size_t camera = 0; camera < 4; ++camera) renderer.render(camera, 0.2, 5, image);
  const size_t made = testing::allocation_count() - before;
  CHECK(made == 0);
}
