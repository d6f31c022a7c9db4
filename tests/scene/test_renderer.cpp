#include <opencv2/imgproc.hpp>
#include <thread>

#include "algorithms/scene/renderer.h"
#include "algorithms/scene/shapes.h"
#include "algorithms/scene/top_view.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::scene;

namespace {

Renderer renderer_of(const Scene& scene) {
  return Renderer(std::make_shared<const World>(scene));
}

cv::Mat rendered(const Renderer& renderer, size_t camera, double time_s = 0, uint64_t frame = 0) {
  cv::Mat image;
  renderer.render(camera, time_s, frame, image);
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Middle of the pixels that are brighter than the ground.
Eigen::Vector2d middle_of_white(const cv::Mat& image) {
  double sum = 0, x = 0, y = 0;
  for (int j = 0; j < image.rows; ++j) {
    for (int i = 0; i < image.cols; ++i) {
      const double weight = std::max(0, image.at<cv::Vec3b>(j, i)[0] - 101);
      sum += weight, x += weight * i, y += weight * j;
    }
  }
  return {x / sum, y / sum};
}

/// No sky, so that nothing but paint is brighter than the ground.
Scene dark_scene(int width_px = 320) {
  Scene scene = testing::small_scene(width_px);
  scene.sky.zenith = scene.sky.horizon = scene.sky.skyline = {0, 0, 0};
  return scene;
}

}  // namespace

TEST_CASE("the same camera, time and frame give the same pixels, in worlds made anew too") {
  Scene scene = testing::small_scene();
  scene.ground.grain_contrast = 0.1;
  scene.path.travel_m = 1;
  for (auto& response : scene.responses) response.noise_sigma = 2;
  const Renderer renderer = renderer_of(scene);
  CHECK(same(rendered(renderer, 1, 0.4, 7), rendered(renderer, 1, 0.4, 7)));
  CHECK(same(rendered(renderer, 1, 0.4, 7), rendered(renderer_of(scene), 1, 0.4, 7)));
  CHECK_FALSE(same(rendered(renderer, 1, 0.4, 7), rendered(renderer, 1, 0.4, 8)));
  scene.seed = 2;
  CHECK_FALSE(same(rendered(renderer, 1, 0.4, 7), rendered(renderer_of(scene), 1, 0.4, 7)));
}

TEST_CASE("cameras can be rendered by different threads at the same time") {
  const Renderer renderer = renderer_of(testing::small_scene());
  cv::Mat images[4];
  std::vector<std::thread> threads;
  for (size_t c = 0; c < 4; ++c) threads.emplace_back([&, c] { renderer.render(c, 0.1, 3, images[c]); });
  for (auto& thread : threads) thread.join();
  for (size_t c = 0; c < 4; ++c) CHECK(same(images[c], rendered(renderer, c, 0.1, 3)));
}

TEST_CASE("a corner of a chart is seen where the lens puts it") {
  Scene scene = testing::small_scene(1280);
  scene.ground.metres_per_texel = 0.005;
  scene.charts.push_back({"front_left", {5, 4}, 0.3, {3.4, 1.2, 0.2}});
  scene.charts.push_back({"front_right", {5, 4}, 0.3, {3.3, -1.3, -0.4}});
  const cv::Mat image = rendered(renderer_of(scene), 0);
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, grey, {0, 0}, 0.7);  // as a lens would, for the sake of cornerSubPix
  double squares = 0;
  int count = 0;
  for (const auto& board : scene.charts) {
    for (int i = 1; i < board.squares[0]; ++i) {
      for (int j = 1; j < board.squares[1]; ++j) {
        const Eigen::Vector2d place = board.corner(i, j);
        const auto expected = scene.rig.cameras[0].see({place.x(), place.y(), 0});
        REQUIRE(expected);
        std::vector<cv::Point2f> corner = {
            cv::Point2f(float(expected->x()) + 0.3f, float(expected->y()) - 0.3f)};
        cv::cornerSubPix(grey, corner, {5, 5}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-4});
        const double distance = std::hypot(corner[0].x - expected->x(), corner[0].y - expected->y());
        CHECK(distance < 0.12);
        squares += distance * distance;
        ++count;
      }
    }
  }
  CHECK(count == 24);
  CHECK(std::sqrt(squares / count) < 0.06);
}

TEST_CASE("the ideal top view is what the cameras see, seen from above") {
  Scene scene = testing::small_scene(640);
  for (double x = -3; x <= 3; x += 1.5) {
    scene.paint.push_back({disc({x, 2, 0}, 0.4), {40, 90, 220}, 1});
    scene.paint.push_back({rectangle({x, -2, 0.4}, 0.7, 0.5), {210, 160, 30}, 1});
    scene.paint.push_back({rectangle({3.2, x, 0.4}, 0.7, 0.5), {230, 230, 230}, 1});
    scene.paint.push_back({rectangle({-3.2, x, 0.4}, 0.7, 0.5), {20, 40, 20}, 1});
  }
  scene.path.travel_m = 0.8;
  const Renderer renderer = renderer_of(scene);
  const geometry::View view{{110, 140}, 0.05, {0, 0}};
  const double time_s = 1.3;
  const cv::Mat truth = ideal_top_view(renderer.world(), view, time_s);
  for (size_t c = 0; c < 4; ++c) {
    const cv::Mat image = rendered(renderer, c, time_s);
    cv::Mat map(truth.size(), CV_32FC2, cv::Scalar(-1, -1));
    cv::Mat near = cv::Mat::zeros(truth.size(), CV_8U);
    for (int j = 0; j < map.rows; ++j) {
      for (int i = 0; i < map.cols; ++i) {
        const Eigen::Vector2d place = view.ground_from_pixel({i, j});
        const auto& camera = scene.rig.cameras[c];
        const Eigen::Vector3d eye = camera.vehicle_from_camera.translation;
        const auto pixel = camera.see({place.x(), place.y(), 0});
        if (!pixel || (place - eye.head<2>()).norm() > 2.5) continue;
        map.at<cv::Vec2f>(j, i) = {float(pixel->x()), float(pixel->y())};
        near.at<uint8_t>(j, i) = 255;
      }
    }
    cv::Mat seen, difference;
    cv::remap(image, seen, map, cv::noArray(), cv::INTER_LINEAR);
    cv::absdiff(seen, truth, difference);
    CHECK(cv::countNonZero(near) > 1000);
    const cv::Scalar mean = cv::mean(difference, near);
    INFO(geometry::kCameraNames[c]);
    CHECK(mean[0] < 2.5);
    CHECK(mean[1] < 2.5);
    CHECK(mean[2] < 2.5);
  }
}

TEST_CASE("a camera's gains, gamma and falloff change the light as written") {
  Scene scene = testing::small_scene();
  scene.responses[0].gain_bgr = {0.8, 1.0, 1.25};
  scene.responses[1].gamma = 1.2;
  scene.responses[2].falloff = {0.3, 0.1};
  const Renderer renderer = renderer_of(scene);
  const cv::Vec3b front = rendered(renderer, 0).at<cv::Vec3b>(170, 160);
  CHECK(front[0] == Approx(80).margin(1));
  CHECK(front[1] == Approx(100).margin(1));
  CHECK(front[2] == Approx(125).margin(1));
  CHECK(rendered(renderer, 1).at<cv::Vec3b>(170, 160)[1] ==
        Approx(255 * std::pow(100 / 255.0, 1.2)).margin(1));
  CHECK(respond(scene.responses[1], 1, 100) == Approx(255 * std::pow(100 / 255.0, 1.2)));
  const double q2 = std::pow((170 - 89.5) / 160, 2);
  CHECK(rendered(renderer, 2).at<cv::Vec3b>(170, 160)[1] ==
        Approx(100 / (1 + 0.3 * q2 + 0.1 * q2 * q2)).margin(1));
}

TEST_CASE("noise has the asked deviation and no mean") {
  Scene scene = testing::small_scene();
  scene.responses[0].noise_sigma = 4;
  const cv::Mat ground = rendered(renderer_of(scene), 0)(cv::Rect(110, 120, 100, 60));
  cv::Scalar mean, deviation;
  cv::meanStdDev(ground, mean, deviation);
  for (int c = 0; c < 3; ++c) {
    CHECK(mean[c] == Approx(100).margin(0.2));
    CHECK(deviation[c] == Approx(4).margin(0.2));
  }
}

TEST_CASE("as the vehicle drives forward the ground flows backward") {
  Scene scene = dark_scene();
  scene.paint.push_back({disc({4.5, 0, 0}, 0.08), {255, 255, 255}, 1});
  scene.path = {1, 8, 1000};
  const Renderer renderer = renderer_of(scene);
  for (const double time_s : {0.0, 1.0, 2.0, 6.0}) {
    const double ahead = 4.5 - std::sin(2 * 3.14159265358979 * time_s / 8);
    const auto expected = scene.rig.cameras[0].see({ahead, 0, 0});
    REQUIRE(expected);
    const Eigen::Vector2d seen = middle_of_white(rendered(renderer, 0, time_s));
    INFO(time_s);
    CHECK(seen.x() == Approx(expected->x()).margin(0.3));
    CHECK(seen.y() == Approx(expected->y()).margin(0.5));
  }
}

TEST_CASE("beyond the lens is black, above the horizon is sky") {
  Scene scene = testing::small_scene();
  for (auto& response : scene.responses) response.noise_sigma = 3;
  const cv::Mat image = rendered(renderer_of(scene), 0);
  CHECK(image.at<cv::Vec3b>(0, 0) == cv::Vec3b(0, 0, 0));
  CHECK(image.at<cv::Vec3b>(179, 319) == cv::Vec3b(0, 0, 0));
  CHECK(image.at<cv::Vec3b>(5, 160)[0] > 150);
}

TEST_CASE("rendering a frame allocates nothing") {
  Scene scene = testing::small_scene();
  scene.path.travel_m = 1;
  const Renderer renderer = renderer_of(scene);
  cv::Mat image(180, 320, CV_8UC3);
  const uint8_t* pixels = image.data;
  const size_t before = testing::allocation_count();
  for (size_t camera = 0; camera < 4; ++camera) renderer.render(camera, 0.2, 5, image);
  const size_t made = testing::allocation_count() - before;
  CHECK(made == 0);
  CHECK(image.data == pixels);
}
