#include "algorithms/car/car_picture.h"

#include <opencv2/core.hpp>

#include "algorithms/car/default_car.h"
#include "tests/allocation_count.h"
#include "tests/car/look_at.h"
#include "tests/car/small_models.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::car;
using namespace svchain::testing;

namespace {

const Material kRed = {"red", {0.8f, 0, 0}, 1, 0, 0}, kGreen = {"green", {0, 0.8f, 0}, 1, 0, 0};
const Material kPane = {"glass", {0, 0, 0}, 0.3f, 1, 0};
const geometry::Vehicle kNoShadow = {1e-4, 1e-4};  // too small to be seen
const geometry::Vehicle kCar = {4.8, 1.9};

CarModel unit_box(const Material& material) {
  return box_model({-0.5f, -0.5f, 0}, {0.5f, 0.5f, 1}, material);
}

cv::Mat grey(const Viewpoint& viewpoint) {
  return {viewpoint.size_px.y(), viewpoint.size_px.x(), CV_8UC3, cv::Scalar(90, 91, 92)};
}

cv::Mat picture_of(CarPicture& car, const Viewpoint& viewpoint, float opacity = 1) {
  cv::Mat picture = grey(viewpoint);
  car.render(viewpoint, opacity);
  car.blend_over(picture);
  return picture;
}

int changed(const cv::Mat& picture, const cv::Mat& before) {
  cv::Mat difference;
  cv::absdiff(picture, before, difference);
  int count = 0;
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) count += difference.at<cv::Vec3b>(y, x) != cv::Vec3b(0, 0, 0);
  return count;
}

/// How far inside the projected box a pixel lies: its faces are planes through the eye's rays.
bool ray_meets_box(const Viewpoint& viewpoint, const Eigen::Vector2d& pixel, double margin_px) {
  const double radius = margin_px / viewpoint.focal_px * viewpoint.eye.norm();  // at about the box's distance
  const Eigen::Vector3d ray = viewpoint.camera_from_vehicle.transpose() *
                              ((pixel - viewpoint.centre_px) / viewpoint.focal_px).homogeneous();
  const Eigen::Array3d low(-0.5 - radius, -0.5 - radius, -radius),
      high(0.5 + radius, 0.5 + radius, 1 + radius);
  const Eigen::Array3d a = (low - viewpoint.eye.array()) / ray.array();
  const Eigen::Array3d b = (high - viewpoint.eye.array()) / ray.array();
  return a.min(b).maxCoeff() <= a.max(b).minCoeff();
}

}  // namespace

TEST_CASE("the silhouette of a box is its analytic projection within a pixel") {
  CarPicture car(unit_box(kRed), kNoShadow);
  for (const Eigen::Vector3d& eye : {Eigen::Vector3d(3, 2, 2), {-2, 3, 1.5}, {0.3, -4, 0.6}, {0.1, 0.2, 5}}) {
    const Viewpoint viewpoint = look_at(eye, {0.1, 0, 0.5}, 250.3, {201, 163});
    const cv::Mat before = grey(viewpoint), picture = picture_of(car, viewpoint);
    int wrong = 0, inside = 0;
    for (int y = 0; y < picture.rows; ++y)
      for (int x = 0; x < picture.cols; ++x) {
        const bool drawn = picture.at<cv::Vec3b>(y, x) != before.at<cv::Vec3b>(y, x);
        if (ray_meets_box(viewpoint, {x, y}, -1)) wrong += !drawn, ++inside;
        if (!ray_meets_box(viewpoint, {x, y}, 1)) wrong += drawn;
      }
    CHECK(inside > 1000);
    CHECK(wrong == 0);
  }
}

TEST_CASE("the nearer of two boxes hides the other, whichever is drawn first") {
  const CarModel front = box_model({1, -0.5f, 0}, {2, 0.5f, 1}, kRed);
  const CarModel rear = box_model({-2, -0.5f, 0}, {-1, 0.5f, 1}, kGreen);
  for (const bool front_first : {true, false}) {
    CarPicture car(front_first ? joined(front, rear) : joined(rear, front), kNoShadow);
    for (const double side : {1.0, -1.0}) {
      const Viewpoint viewpoint = look_at({side * 8, 0, 0.5}, {0, 0, 0.5}, 300, {101, 101});
      const cv::Vec3b middle = picture_of(car, viewpoint).at<cv::Vec3b>(50, 50);
      CHECK((side > 0) == (middle[2] > middle[1] + 30));
      CHECK((side < 0) == (middle[1] > middle[2] + 30));
    }
  }
}

TEST_CASE("what is behind glass is seen through it, and what is before it is not") {
  const CarModel inner = box_model({-0.2f, -0.2f, 0.3f}, {0.2f, 0.2f, 0.7f}, kGreen);
  const CarModel outer = box_model({1.5f, -0.2f, 0.3f}, {1.6f, 0.2f, 0.7f}, kGreen);
  const Viewpoint viewpoint = look_at({6, 0, 0.5}, {0, 0, 0.5}, 300, {101, 101});
  CarPicture plain(inner, kNoShadow), behind(joined(unit_box(kPane), inner), kNoShadow);
  CarPicture before(joined(unit_box(kPane), outer), kNoShadow), alone(outer, kNoShadow);
  const auto middle = [&](CarPicture& car) { return picture_of(car, viewpoint).at<cv::Vec3b>(50, 50); };
  CHECK(middle(behind)[1] > middle(behind)[2] + 20);
  CHECK(middle(behind)[1] < middle(plain)[1] - 5);
  CHECK(middle(before)[1] == middle(alone)[1]);
  // And nothing but the glass lets the picture through.
  CarPicture pane(unit_box(kPane), kNoShadow);
  pane.render(viewpoint);
  const cv::Rect& where = pane.rectangle();
  const int alpha = pane.premultiplied().at<cv::Vec4b>(50 - where.y, 50 - where.x)[3];
  CHECK(alpha == Approx(255 * (0.3 + 0.7 * 0.04)).margin(2));
}

TEST_CASE("opacity 0 leaves the picture untouched, 1 covers it, and one half is half of both") {
  CarPicture car(unit_box(kRed), kCar);
  const Viewpoint viewpoint = look_at({6, 1, 3}, {0, 0, 0.5}, 150, {161, 121});
  const cv::Mat before = grey(viewpoint);
  CHECK(changed(picture_of(car, viewpoint, 0), before) == 0);
  const cv::Mat half = picture_of(car, viewpoint, 0.5f), whole = picture_of(car, viewpoint, 1);
  const cv::Rect& where = car.rectangle();
  CHECK(car.premultiplied().at<cv::Vec4b>(60 - where.y, 80 - where.x)[3] == 255);
  CHECK(changed(whole, before) > 1000);
  for (int y = 0; y < before.rows; ++y)
    for (int x = 0; x < before.cols; ++x)
      for (int c = 0; c < 3; ++c) {
        const double mean = (before.at<cv::Vec3b>(y, x)[c] + whole.at<cv::Vec3b>(y, x)[c]) / 2.0;
        REQUIRE(std::abs(half.at<cv::Vec3b>(y, x)[c] - mean) <= 1.6);
      }
}

TEST_CASE(
    "the shadow darkens the ground as its formula says, and nothing where the eye is below the ground") {
  CarPicture car(box_model({-0.01f, -0.01f, 0.0f}, {0.01f, 0.01f, 0.02f}, kRed), kCar);
  const Viewpoint above = look_at({0, 0, 10}, {0, 0, 0}, 200, {81, 141});
  const cv::Mat picture = picture_of(car, above);
  const ContactShadow shadow(kCar);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const Eigen::Vector2f ground(static_cast<float>(70 - y) / 20, static_cast<float>(40 - x) / 20);
      if (ground.norm() < 0.1f) continue;  // the model
      REQUIRE(picture.at<cv::Vec3b>(y, x)[0] == Approx(90 * (1 - shadow.shadow_at(ground))).margin(1.1));
    }
  const Viewpoint below = look_at({0, 0, -10}, {0, 0, 0}, 200, {81, 141});
  CHECK(changed(picture_of(car, below), grey(below)) < 10);
}

TEST_CASE("a viewpoint that stands still costs a blend that allocates nothing") {
  CarPicture car(default_car(kCar), kCar);
  const Viewpoint viewpoint = look_at({6, 4, 3}, {0, 0, 0.5}, 300, {300, 260});
  cv::Mat picture = picture_of(car, viewpoint);
  const size_t before = allocation_count();
  car.blend_over(picture);
  CHECK(allocation_count() == before);
  car.render(viewpoint, 0.7f);  // no larger than it was
  CHECK(allocation_count() == before);
}

TEST_CASE("blending again after rendering again gives the same picture") {
  CarPicture car(default_car(kCar), kCar);
  const Viewpoint viewpoint = look_at({6, 4, 3}, {0, 0, 0.5}, 300, {300, 260});
  const cv::Mat first = picture_of(car, viewpoint);
  picture_of(car, look_at({-3, 2, 5}, {0, 0, 0.5}, 500, {640, 200}));
  CHECK(changed(picture_of(car, viewpoint), first) == 0);
}

TEST_CASE("drawn in parts, in whatever order, the picture is the same") {
  CarPicture car(default_car(kCar), kCar);
  const Viewpoint viewpoint = look_at({6, 4, 3}, {0, 0, 0.5}, 300, {301, 263});
  const cv::Mat whole = picture_of(car, viewpoint);
  CHECK(changed(whole, grey(viewpoint)) > 10000);
  for (const int parts : {2, 7, CarPicture::kMostParts}) {
    car.begin(viewpoint);
    for (int part = parts; part-- > 0;) car.draw(part, parts);
    cv::Mat picture = grey(viewpoint);
    car.blend_over(picture);
    CHECK(changed(picture, whole) == 0);
  }
}

TEST_CASE("once a viewpoint has been all around, going around again allocates nothing") {
  CarPicture car(default_car(kCar), kCar);
  const auto go_around = [&] {
    for (int step = 0; step < 12; ++step) {
      const double angle = 0.5236 * step;
      car.begin(look_at({7 * std::cos(angle), 7 * std::sin(angle), 3}, {0, 0, 0.5}, 300, {300, 260}));
      for (int part = 0; part < 3; ++part) car.draw(part, 3);
    }
  };
  go_around();
  const size_t before = allocation_count();
  go_around();
  CHECK(allocation_count() == before);
}

TEST_CASE("a car partly or wholly out of view, or around the eye, is drawn within the picture only") {
  CarPicture car(default_car(kCar), kCar);
  const Eigen::Vector2i size(120, 90);
  const std::vector<Viewpoint> viewpoints = {
      look_at({6, 0, 2}, {0, 6, 0}, 100, size),         look_at({6, 0, 2}, {3, -5, 0}, 80, size),
      look_at({6, 0, 2}, {12, 0, 2}, 100, size),        look_at({0, 0, 1}, {2, 0.3, 0.9}, 60, size),
      look_at({2.0, 0.4, 0.6}, {0, 0, 0.5}, 60, size),  look_at({0.01, 0, 0.02}, {0, 0, 1}, 60, size),
      look_at({2.41, 0, 0.5}, {0, 0, 0.5}, 5000, size), look_at({1e4, 0, 1e3}, {0, 0, 0}, 100, size)};
  for (const Viewpoint& viewpoint : viewpoints) {
    cv::Mat canvas(size.y() + 8, size.x() + 8, CV_8UC3, cv::Scalar(90, 91, 92));
    cv::Mat picture = canvas(cv::Rect(4, 4, size.x(), size.y()));
    car.render(viewpoint);
    car.blend_over(picture);
    const cv::Mat whole(canvas.size(), CV_8UC3, cv::Scalar(90, 91, 92));
    CHECK(changed(canvas, whole) == changed(picture, whole(cv::Rect(4, 4, size.x(), size.y()))));
    const cv::Rect all(0, 0, size.x(), size.y());
    CHECK((car.rectangle() & all) == car.rectangle());
  }
  CHECK(changed(picture_of(car, viewpoints[2]), grey(viewpoints[2])) == 0);
  CHECK(changed(picture_of(car, viewpoints[3]), grey(viewpoints[3])) > 1000);
  CHECK(changed(picture_of(car, viewpoints[6]), grey(viewpoints[6])) > 10000);
}

TEST_CASE("a picture of another size or kind than the viewpoint's is refused") {
  CarPicture car(unit_box(kRed), kCar);
  car.render(look_at({6, 1, 3}, {0, 0, 0.5}, 150, {161, 121}));
  cv::Mat other(121, 160, CV_8UC3), single(121, 161, CV_8UC1);
  CHECK_THROWS_AS(car.blend_over(other), std::invalid_argument);
  CHECK_THROWS_AS(car.blend_over(single), std::invalid_argument);
}

TEST_CASE("looking straight down, the vehicle's front is up and its left is left") {
  const Viewpoint viewpoint = look_at({0, 0, 10}, {0, 0, 0}, 100, {101, 101});
  CHECK(viewpoint.pixel(viewpoint.seen({1, 0, 0})).isApprox(Eigen::Vector2d(50, 40), 1e-9));
  CHECK(viewpoint.pixel(viewpoint.seen({0, 1, 0})).isApprox(Eigen::Vector2d(40, 50), 1e-9));
}
