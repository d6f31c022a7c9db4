#include "algorithms/registration/alignment.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include "algorithms/registration/ground_picture.h"
#include "algorithms/scene/shapes.h"
#include "algorithms/scene/still_renderer.h"
#include "algorithms/scene/top_view.h"
#include "tests/catch.h"
#include "tests/registration/perspectives.h"
#include "tests/scene/small_scene.h"

using namespace svchain;
using namespace svchain::registration;

namespace {

/// A car on asphalt between charts whose places nobody knows, as unlike cameras see it.
scene::Scene parking_scene() {
  scene::Scene scene = testing::small_scene(960);
  scene.ground.grain_contrast = 0.1;
  scene.ground.grain_m = 0.02;
  scene.ground.metres_per_texel = 0.005;
  scene.ground.half_extent_m = 6;
  scene.charts = {{"a", {5, 4}, 0.25, {3.3, 1.9, 0.1}},
                  {"b", {5, 4}, 0.25, {3.2, -1.8, -0.2}},
                  {"c", {5, 4}, 0.25, {-3.2, -1.9, 0.05}},
                  {"d", {5, 4}, 0.25, {-3.3, 1.8, -0.1}}};
  for (const double x : {4.4, -4.4}) {
    scene.paint.push_back({scene::rectangle({x, 3.0, 0.5}, 0.8, 0.3), {220, 220, 220}, 1});
    scene.paint.push_back({scene::rectangle({x, -2.9, -0.3}, 0.5, 0.5), {40, 60, 180}, 1});
  }
  const double gains[4] = {1, 0.8, 1.15, 0.9};
  for (size_t i = 0; i < 4; ++i) {
    scene.responses[i].gain_bgr = {gains[i], gains[i], gains[i]};
    scene.responses[i].noise_sigma = 2;
  }
  return scene;
}

struct Recorded {
  scene::Scene scene = parking_scene();
  std::array<cv::Mat, 4> frames;

  Recorded() {
    const scene::StillRenderer renderer(std::make_shared<const scene::World>(scene));
    for (size_t i = 0; i < 4; ++i) frames[i] = renderer.render(i, 0, 0);
  }
};

const Recorded& recorded() {
  static const Recorded recorded;
  return recorded;
}

AlignmentTask task_from(const geometry::Rig& rig, double position_m, double rotation_deg) {
  return testing::task_of(rig, recorded().frames, position_m, rotation_deg);
}

/// RMS distance between where two neighbours put the ground around the chart they share, by rays that are
/// true: what no feature has told.
double gap_m(const Perspectives& found, size_t a) {
  const Perspectives truth = testing::perspectives_of(recorded().scene.rig);
  const size_t b = (a + 1) % 4;
  const scene::Pose2& chart = recorded().scene.charts[std::array<size_t, 4>{1, 2, 3, 0}[a]].world_from_chart;
  double squares = 0;
  int count = 0;
  for (double x = -0.7; x <= 0.7; x += 0.1) {
    for (double y = -0.7; y <= 0.7; y += 0.1, ++count) {
      const Eigen::Vector3d ground = (chart * Eigen::Vector2d(x, y)).homogeneous();
      const Eigen::Vector2d by_a = ground_of(found[a].inverse(), truth[a] * ground);
      const Eigen::Vector2d by_b = ground_of(found[b].inverse(), truth[b] * ground);
      squares += (by_a - by_b).squaredNorm();
    }
  }
  return std::sqrt(squares / count);
}

/// RMS distance from where the ground is, over all that each camera sees within 3 m of the vehicle, after the
/// best common motion and scale.
double shape_error_m(const Perspectives& found) {
  const geometry::Rig& rig = recorded().scene.rig;
  const Perspectives truth = testing::perspectives_of(rig);
  const double x_m = rig.vehicle.length_m / 2, y_m = rig.vehicle.width_m / 2;
  std::vector<Eigen::Vector2d> wanted, got;
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d outward = std::array<Eigen::Vector2d, 4>{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}}[i];
    for (double x = -x_m - 3; x <= x_m + 3; x += 0.25) {
      for (double y = -y_m - 3; y <= y_m + 3; y += 0.25) {
        const Eigen::Vector2d ground(x, y);
        if (outward.dot(ground) < (i % 2 == 0 ? x_m : y_m) || !rig.cameras[i].see({x, y, 0})) continue;
        wanted.push_back(ground);
        got.push_back(ground_of(found[i].inverse(), truth[i] * ground.homogeneous()));
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(wanted.size());
  Eigen::Matrix2Xd to(2, count), from(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    to.col(i) = wanted[static_cast<size_t>(i)];
    from.col(i) = got[static_cast<size_t>(i)];
  }
  const Eigen::Matrix3d motion = Eigen::umeyama(from, to, true);
  const Eigen::Vector2d shift = motion.topRightCorner<2, 1>();
  double squares = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    squares += (motion.topLeftCorner<2, 2>() * from.col(i) + shift - to.col(i)).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(count));
}

std::string text(const Faults& faults) {
  std::string all;
  for (const auto& fault : faults) all += fault.text() + "\n";
  return all;
}

}  // namespace

TEST_CASE("a ground picture shows the ground as one perfect camera straight above would") {
  const auto& scene = recorded().scene;
  geometry::View view{{120, 120}, 0.01, {3.3, 1.9}};
  const auto camera = testing::task_of(scene.rig, recorded().frames, 0, 0).cameras[0];
  const cv::Mat found = ground_picture(pyramid(recorded().frames[0]), camera, view);
  cv::Mat ideal;
  cv::cvtColor(scene::ideal_top_view(scene::World(scene), view, 0), ideal, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(ideal, ideal, {0, 0}, 1);
  ideal.convertTo(ideal, CV_32F);
  cv::Scalar mean_found, spread_found, mean_ideal, spread_ideal;
  cv::meanStdDev(found, mean_found, spread_found);
  cv::meanStdDev(ideal, mean_ideal, spread_ideal);
  const double together = (found - mean_found[0]).dot(ideal - mean_ideal[0]) /
                          (static_cast<double>(found.total()) * spread_found[0] * spread_ideal[0]);
  CHECK(together > 0.95);
}

TEST_CASE("a ground picture is 0 where the camera does not look") {
  const auto camera = task_from(recorded().scene.rig, 0, 0).cameras[0];
  const geometry::View behind{{20, 20}, 0.01, {-4, 0}};
  CHECK(cv::countNonZero(ground_picture(pyramid(recorded().frames[0]), camera, behind)) == 0);
}

TEST_CASE("from cameras 5 cm and 3 degrees off, features alone bring all overlaps together") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto start = testing::disturbed(recorded().scene.rig, 0.05, 3, seed);
    const auto aligned = align(task_from(start, 0.05, 3));
    INFO("seed " << seed << (aligned ? "" : "\n" + text(aligned.error())));
    REQUIRE(aligned);
    for (size_t a = 0; a < 4; ++a) {
      const auto& overlap = aligned->overlaps[a];
      CAPTURE(a, overlap.matches.size(), overlap.residual_rms_px());
      CHECK(overlap.inliers() >= 15);
      CHECK(overlap.held_out_rms_px() < 0.5);
      CHECK(gap_m(testing::perspectives_of(start), a) > 0.02);
      CHECK(gap_m(aligned->ray_from_ground, a) < 0.005);
    }
  }
}

TEST_CASE("where lenses are known, features alone give the ground its true shape to 2 mm") {
  for (const unsigned seed : {1U, 2U}) {
    const auto start = testing::disturbed(recorded().scene.rig, 0.05, 3, seed);
    auto task = task_from(start, 0.05, 3);
    task.start.stretch = 1e-4;
    const auto aligned = align(task);
    REQUIRE(aligned);
    CHECK(shape_error_m(testing::perspectives_of(start)) > 0.1);
    CHECK(shape_error_m(aligned->ray_from_ground) < 0.002);
  }
}

TEST_CASE("with halves held out, too, the overlaps agree within half a pixel") {
  auto task = task_from(testing::disturbed(recorded().scene.rig, 0.02, 1, 5), 0.02, 1);
  task.folds = 2;
  const auto aligned = align(task);
  REQUIRE(aligned);
  for (const auto& overlap : aligned->overlaps) CHECK(overlap.held_out_rms_px() < 0.5);
}

TEST_CASE("matches tell where both cameras show them") {
  const auto aligned = align(task_from(testing::disturbed(recorded().scene.rig, 0.02, 1, 6), 0.02, 1));
  REQUIRE(aligned);
  const auto& rig = recorded().scene.rig;
  for (const auto& overlap : aligned->overlaps) {
    CHECK(overlap.b == (overlap.a + 1) % 4);
    for (const auto& match : overlap.matches) {
      if (!match.inlier) continue;
      const auto ray = rig.cameras[overlap.a].lens->unproject(match.pixel_a);
      REQUIRE(ray);
      const Eigen::Vector2d place = ground_of(aligned->ray_from_ground[overlap.a].inverse(), *ray);
      CHECK((place - match.ground_m).norm() < 0.51 * match.residual_px * 0.01 + 1e-6);
    }
  }
}

TEST_CASE("the same frames are aligned the same way twice, and every stage is timed") {
  const auto task = task_from(testing::disturbed(recorded().scene.rig, 0.02, 1, 7), 0.02, 1);
  const auto one = align(task), other = align(task);
  REQUIRE(one);
  REQUIRE(other);
  for (size_t i = 0; i < 4; ++i) CHECK(one->ray_from_ground[i] == other->ray_from_ground[i]);
  std::vector<std::string> stages;
  for (const auto& time : one->times) stages.push_back(time.name);
  CHECK(stages == std::vector<std::string>{"warp", "corners", "describe", "match", "reject", "refine", "fit",
                                           "hold out"});
}

TEST_CASE(
    "an overlap that shows nothing is named, with what was found there; by any matches the others align") {
  auto task = task_from(recorded().scene.rig, 0.02, 1);
  task.frames[1] = cv::Mat(task.frames[1].size(), CV_8UC3, cv::Scalar(90, 90, 90));
  const auto aligned = align(task);
  REQUIRE_FALSE(aligned);
  REQUIRE(aligned.error().size() == 2);
  CHECK(aligned.error()[0].text().find("overlap front-right: error: 0 features agree, expected at least 8") ==
        0);
  CHECK(aligned.error()[1].text().find("overlap right-rear: error: 0 features agree") == 0);

  const auto as_far_as_it_goes = align_by_any_matches(task);
  REQUIRE(as_far_as_it_goes);
  CHECK(as_far_as_it_goes->overlaps[0].matches.empty());
  CHECK(as_far_as_it_goes->overlaps[1].matches.empty());
  CHECK(as_far_as_it_goes->overlaps[2].inliers() >= kFewestMatches);
  CHECK(as_far_as_it_goes->overlaps[3].inliers() >= kFewestMatches);
}

TEST_CASE("a wrong frame, a singular matrix and no uncertainty are told all at once") {
  auto task = task_from(recorded().scene.rig, 0.02, 1);
  task.frames[0] = cv::Mat(10, 20, CV_8UC3);
  task.frames[1].convertTo(task.frames[1], CV_32F);
  task.cameras[2].ray_from_ground.setZero();
  task.start.stretch = 0;
  task.view.metres_per_px = 0;
  task.folds = 1;
  const auto aligned = align(task);
  REQUIRE_FALSE(aligned);
  CHECK(text(aligned.error()) ==
        "front: error: the frame has 20 x 10 pixels, expected 960 x 540\n"
        "right: error: the frame is neither grey nor BGR with 8 bits\n"
        "rear: error: the perspective matrix is singular, expected one that shows the ground\n"
        "uncertainty: error: rotation, position and stretch must all be above 0\n"
        "view: error: metres per pixel must be above 0\n"
        "folds: error: expected at least 2\n");
}
