// A LUT by perspective matrices instead of poses.

#include <algorithm>

#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;

namespace {

struct Built {
  std::vector<std::byte> memory;
  size_t bytes = 0;

  Built(const geometry::Rig& rig, const RaysFromGround& rays, const geometry::View& view)
      : memory(geometric_lut_capacity(view, rig.cameras.size())),
        bytes(build_geometric_lut(rig, rays, view, {}, memory)) {}
  GeometricLut lut() const { return GeometricLut(std::span(memory).first(bytes)); }
};

}  // namespace

TEST_CASE("the matrices of a rig's poses give the LUT that the rig gives, at any factor") {
  const auto rig = four_cameras({640, 360});
  const auto view = view_of(rig, {220, 270});
  const OwnedLut expected(rig, view);
  RaysFromGround rays = rays_from_ground(rig);
  const Built same(rig, rays, view);
  CHECK(std::ranges::equal(std::span(same.memory).first(same.bytes), expected.bytes()));
  for (auto& ray : rays) ray *= 4;  // a power of two, so that no digit changes
  const Built scaled(rig, rays, view);
  CHECK(std::ranges::equal(std::span(scaled.memory).first(scaled.bytes), expected.bytes()));
}

TEST_CASE("entries follow a matrix that no rigid camera has, to half a step") {
  const auto rig = four_cameras({640, 360});
  const auto view = view_of(rig, {220, 270});
  RaysFromGround rays = rays_from_ground(rig);
  for (auto& ray : rays) ray.col(0) *= 1.02;  // the ground stretched along x
  const DecodedLut lut = decode(Built(rig, rays, view).lut());
  size_t compared = 0;
  double largest_px = 0;
  for (int row = 0; row < lut.height; ++row)
    for (int column = 0; column < lut.width; ++column) {
      const DecodedPixel& pixel = lut.at(column, row);
      for (int i = 0; i < pixel.tap_count(); ++i, ++compared) {
        const DecodedTap& tap = pixel.taps[i];
        const Eigen::Vector3d ground = view.ground_from_pixel({column, row}).homogeneous();
        const auto seen = rig.cameras[tap.camera].lens->project(rays[tap.camera] * ground);
        REQUIRE(seen);
        largest_px = std::max({largest_px, std::abs(seen->x() - tap.px()), std::abs(seen->y() - tap.py())});
      }
    }
  CHECK(compared > 40000);
  CHECK(largest_px <= 1.0 / 64 + 1e-9);
}
