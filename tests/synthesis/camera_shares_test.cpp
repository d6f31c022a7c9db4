#include "algorithms/synthesis/camera_shares.h"

#include "tests/catch.h"

using namespace svchain;
using namespace svchain::synthesis;

namespace {

constexpr geometry::Vehicle kCar{4.8, 1.9};
enum { kFront, kRight, kRear, kLeft };

double share_of(int camera, const Eigen::Vector2d& ground, const BlendShape& shape = {}) {
  const CameraShares shares = camera_shares(kCar, shape, ground);
  if (shares.first == camera) return shares.share_of_first;
  return shares.second == camera ? 1 - shares.share_of_first : 0;
}

}  // namespace

TEST_CASE("a side zone belongs to its own camera") {
  CHECK(share_of(kFront, {4, 0.9}) == 1);
  CHECK(share_of(kFront, {4, -0.9}) == 1);
  CHECK(share_of(kRear, {-4, 0.2}) == 1);
  CHECK(share_of(kLeft, {2.3, 2}) == 1);
  CHECK(share_of(kLeft, {-2.3, 2}) == 1);
  CHECK(share_of(kRight, {0, -5}) == 1);
}

TEST_CASE("two neighbours share a corner half and half at 45 degrees around it") {
  CHECK(share_of(kFront, {2.4 + 1, 0.95 + 1}) == Approx(0.5));
  CHECK(share_of(kLeft, {2.4 + 1, 0.95 + 1}) == Approx(0.5));
  CHECK(share_of(kRight, {2.4 + 3, -0.95 - 3}) == Approx(0.5));
  CHECK(share_of(kRear, {-2.4 - 2, -0.95 - 2}) == Approx(0.5));
  CHECK(share_of(kRear, {-2.4 - 2, 0.95 + 2}) == Approx(0.5));
}

TEST_CASE("pairs of neighbours are named clockwise") {
  for (const Eigen::Vector2d& ground : {Eigen::Vector2d(4, 2),
                                        {4, -2},
                                        {-4, 2},
                                        {-4, -2},
                                        {4, 0.1},
                                        {-4, 0.1},
                                        {0.1, 2},
                                        {-0.1, 2},
                                        {0, -2}}) {
    const CameraShares shares = camera_shares(kCar, {}, ground);
    CHECK(shares.second == (shares.first + 1) % 4);
  }
}

TEST_CASE("the fall-off is as wide as asked for, rises steadily, and is the same from both sides") {
  const auto at = [](double angle_deg, const BlendShape& shape) {
    const double angle = angle_deg * M_PI / 180;  // from straight ahead towards the left
    return share_of(kLeft, {2.4 + 3 * std::cos(angle), 0.95 + 3 * std::sin(angle)}, shape);
  };
  struct {
    BlendCurve curve;
    double at_a_quarter, steepest;
  } const curves[] = {{BlendCurve::kSmooth, 0.15625, 1.5},
                      {BlendCurve::kLinear, 0.25, 1},
                      {BlendCurve::kBinary, 0.15625, 1.5}};
  for (const auto& [curve, at_a_quarter, steepest] : curves) {
    for (const double width : {20.0, 60.0, 90.0}) {
      CAPTURE(width, static_cast<int>(curve));
      const BlendShape shape{width, curve};
      CHECK(at(45 - width / 2 - 1e-6, shape) == 0);
      CHECK(at(45 + width / 2 + 1e-6, shape) == 1);
      CHECK(at(45 - width / 4, shape) == Approx(at_a_quarter));
      for (double angle = 0; angle < 90; ++angle) {
        const double step = at(angle + 1, shape) - at(angle, shape);
        CHECK(step >= 0);
        CHECK(step <= steepest / width + 1e-9);
        CHECK(at(angle, shape) == Approx(1 - at(90 - angle, shape)).margin(1e-9));
      }
    }
  }
}

TEST_CASE("a binary curve shows the camera that has more of a pixel, the others show the weight as it is") {
  for (int weight = 0; weight <= 255; ++weight) {
    CHECK(shown_weight({60, BlendCurve::kBinary}, weight) == (weight >= 128 ? 255 : 0));
    CHECK(shown_weight({60, BlendCurve::kSmooth}, weight) == weight);
    CHECK(shown_weight({60, BlendCurve::kLinear}, weight) == weight);
  }
}

TEST_CASE("in the middle between two cameras a binary curve shows the one that has faded less") {
  const BlendShape binary{60, BlendCurve::kBinary};
  for (double fade = 0.05; fade < 1; fade += 0.05) {
    CHECK(shown_weight(binary, first_weight(binary, 0.5, fade, 1)) == 0);
    CHECK(shown_weight(binary, first_weight(binary, 0.5, 1, fade)) == 255);
    CHECK(shown_weight(binary, first_weight(binary, 1, fade, 1)) == (fade > 0.501 ? 255 : 0));
  }
}

TEST_CASE("a width of zero decides for one camera or the other") {
  CHECK(share_of(kLeft, {2.4 + 1, 0.95 + 0.99}, {0}) == 0);
  CHECK(share_of(kLeft, {2.4 + 0.99, 0.95 + 1}, {0}) == 1);
  for (double fade = 0; fade <= 1; fade += 0.1) {
    const int weight = first_weight({0}, 0, fade, 0.4);
    CHECK((weight == 0 || weight == 255));
  }
}

TEST_CASE("the vehicle's rectangle includes its edge and nothing beyond") {
  CHECK(is_under_vehicle(kCar, {2.4, 0.95}));
  CHECK(is_under_vehicle(kCar, {0, 0}));
  CHECK_FALSE(is_under_vehicle(kCar, {2.4001, 0}));
  CHECK_FALSE(is_under_vehicle(kCar, {0, -0.9501}));
}

TEST_CASE("a camera that sees a point alone has all its weight") {
  for (double share = 0; share <= 1; share += 0.125) {
    CHECK(first_weight({}, share, 0.3, 0) == 255);
    CHECK(first_weight({}, share, 0, 0.001) == 0);
  }
}

TEST_CASE("where nothing fades the weight is the share") {
  CHECK(first_weight({}, 0.5, 1, 1) == 128);
  CHECK(first_weight({}, 0.2, 1, 1) == 51);
  CHECK(first_weight({}, 1, 1, 1) == 255);
}

TEST_CASE("a camera hands over its weight as it fades") {
  for (const double share : {0.0, 0.3, 1.0}) {
    int before = 0;
    for (double fade = 0; fade <= 1; fade += 0.01) {
      const int weight = first_weight({}, share, fade, 1);
      CHECK(weight >= before);
      CHECK(weight - before <= 4);
      before = weight;
    }
  }
}
