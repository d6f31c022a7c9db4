#include "algorithms/synthesis/lut_header.h"

#include <cmath>

#include "algorithms/synthesis/fixed_point.h"

namespace svchain::synthesis {
namespace {

/// 1/32 px. Falloff is about the axis; a lens that does not see it is one whose image has no such centre.
std::array<int32_t, 2> lens_centre(const geometry::Camera& camera) {
  const auto centre = camera.lens->project({0, 0, 1});
  const Eigen::Vector2d px =
      centre ? *centre : (camera.image_size_px.cast<double>() - Eigen::Vector2d::Ones()) / 2;
  return {static_cast<int32_t>(std::lround(px.x() * kOnePixel)),
          static_cast<int32_t>(std::lround(px.y() * kOnePixel))};
}

}  // namespace

void fill_header(LutHeader& header, const geometry::Rig& rig, const Eigen::Vector2i& size_px) {
  header.magic = kLutMagic;
  header.version = kLutVersion;
  header.camera_count = 4;
  header.block_count = static_cast<uint32_t>(block_count(size_px));
  header.width = size_px.x();
  header.height = size_px.y();
  for (int i = 0; i < 4; ++i) {
    const geometry::Camera& camera = rig.cameras[i];
    header.image_size_px[i] = {camera.image_size_px.x(), camera.image_size_px.y()};
    header.lens_centre[i] = lens_centre(camera);
  }
}

}  // namespace svchain::synthesis
