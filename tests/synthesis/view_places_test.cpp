#include "algorithms/synthesis/view_places.h"

#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;

TEST_CASE(
    "a camera's pixel is found in the composite where the ground it shows lies, to a tenth of a pixel") {
  const auto rig = four_cameras();
  const auto view = view_of(rig, {440, 540});
  const OwnedLut owned(rig, view);
  const DecodedLut lut = decode(owned.lut());
  for (int camera = 0; camera < 4; ++camera) {
    const ViewPlaces places(owned.lut(), camera);
    size_t compared = 0;
    double largest = 0;
    for (int row = 20; row < lut.height; row += 37)
      for (int column = 20; column < lut.width; column += 37) {
        if (lut.at(column, row).weight_of(camera) == 0) continue;
        const Eigen::Vector2d place(column + 0.3, row - 0.4);
        const Eigen::Vector2d ground = view.ground_from_pixel(place);
        const auto pixel = rig.cameras[camera].see({ground.x(), ground.y(), 0});
        if (!pixel) continue;
        const auto found = places.find(*pixel);
        REQUIRE(found);
        largest = std::max(largest, (*found - place).norm());
        ++compared;
      }
    CAPTURE(camera);
    CHECK(compared >= 20);
    CHECK(largest < 0.1);
  }
}

TEST_CASE("a camera's pixel that the composite does not show is not found") {
  const auto rig = four_cameras();
  const OwnedLut owned(rig, view_of(rig, {440, 540}));
  const ViewPlaces front(owned.lut(), 0);
  CHECK_FALSE(front.find({640, 5}));    // the sky
  CHECK_FALSE(front.find({-50, 300}));  // outside the image
}
