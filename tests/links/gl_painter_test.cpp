// What becomes of the 3D view where the driver gives its context up.

#include "links/bowl/gl_painter.h"

#include "tests/catch.h"
#include "tests/gl/parking.h"
#include "tests/gl_loss.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;
using Loss = GlLoss::Kind;

namespace {

/// A painter of parking() with its car and its mesh table.
struct ParkingPainter {
  ParkingPainter() {
    painter.set_car(parking().car, parking().rig.vehicle, 1);
    set_mesh();
  }
  void set_mesh() { painter.set_mesh(parking().mesh.table(), parking().rig); }
  cv::Mat painted() {
    cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
    painter.paint(parking().bgr.pictures, synthesis::ToneMapping::identity(), parking().preset("chase"),
                  colour::bgr_picture(picture));
    return picture;
  }

  GlPainter painter{kPicture};
};

bool same(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0;
}

}  // namespace

TEST_CASE("a GL context lost while painting is made anew with car and mesh, and the picture is the same") {
  if (!has_gl()) return;
  ParkingPainter parking_painter;
  static_cast<void>(parking_painter.painted());  // the car's edges are finer from the second frame on
  const cv::Mat before = parking_painter.painted();
  cv::Mat after;
  {
    const GlLoss loss(Loss::kOnce);
    after = parking_painter.painted();
    CHECK(GlLoss::questions() > 1);  // the new context was asked too
  }
  CHECK(parking_painter.painter.times_lost() == 1);
  const cv::Mat still = parking_painter.painted();
  CHECK(same(still, before));
  CHECK(mean_difference(after, before) < 0.5);  // the car's edges
  CHECK(parking_painter.painter.times_lost() == 1);
}

TEST_CASE("a GL context lost while a mesh table is taken is made anew with that mesh table") {
  if (!has_gl()) return;
  ParkingPainter parking_painter;
  const cv::Mat before = parking_painter.painted();
  const GlLoss loss(Loss::kOnce);
  parking_painter.set_mesh();
  CHECK(parking_painter.painter.times_lost() == 1);
  CHECK(same(parking_painter.painted(), before));
}

TEST_CASE(
    "a GL context lost for good is an error that says so, and painting goes on where there is GL again") {
  if (!has_gl()) return;
  ParkingPainter parking_painter;
  const cv::Mat before = parking_painter.painted();
  for (const Loss kind : {Loss::kForGood, Loss::kAlways}) {
    {
      const GlLoss loss(kind);
      CHECK_THROWS_WITH(parking_painter.painted(), Contains("the context is lost") && Contains("a new one"));
      CHECK_THROWS_AS(parking_painter.painted(), std::runtime_error);
      CHECK_THROWS_AS(parking_painter.set_mesh(), std::runtime_error);
    }
    CHECK(same(parking_painter.painted(), before));
  }
}
