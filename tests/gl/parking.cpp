#include "tests/gl/parking.h"

#include <cmath>

#include "algorithms/bowl/viewpoint_lut.h"
#include "algorithms/bowl/viewpoint_presets.h"
#include "algorithms/car/car_picture.h"
#include "algorithms/car/default_car.h"
#include "algorithms/colour/convert.h"
#include "algorithms/scene/renderer.h"
#include "algorithms/scene/scene_file.h"
#include "algorithms/synthesis/synthesize.h"
#include "tests/catch.h"
#include "tests/test_data.h"

namespace svchain::testing {
namespace {

scene::Scene parking_scene() {
  auto scene = scene::read_scene(project_folder() / "configs" / "scenes" / "parking.json");
  REQUIRE(scene);
  return *scene;
}

}  // namespace

Parking::Parking()
    : rig(parking_scene().rig),
      surface(bowl::default_surface(rig.vehicle)),
      mesh(rig, surface),
      car(car::default_car(rig.vehicle)) {
  const scene::Renderer renderer(std::make_shared<scene::World>(parking_scene()));
  for (size_t c = 0; c < 4; ++c) {
    renderer.render(c, 1.0, 0, bgr.memory[c]);
    bgr.pictures[c] = colour::bgr_picture(bgr.memory[c]);
  }
}

bowl::Viewpoint Parking::preset(const std::string& name) const {
  return *bowl::preset(name, rig.vehicle, surface);
}

const Parking& parking() {
  static const Parking made;
  return made;
}

Frames in_yuv(const Frames& bgr, colour::PixelFormat format, colour::YuvEncoding encoding) {
  Frames yuv;
  for (size_t c = 0; c < 4; ++c) {
    const colour::Picture& frame = bgr.pictures[c];
    const int width = frame.width_px, height = frame.height_px;
    yuv.memory[c].create(2 * height, 2 * width + 6, CV_8U);
    uint8_t* const data = yuv.memory[c].data;
    // Rows with a gap behind them, of a whole number of groups and not.
    yuv.pictures[c] = format == colour::PixelFormat::kNv12
                          ? colour::nv12_picture(width, height, width + (c % 2 ? 6 : 0), data, encoding)
                          : colour::yuyv_picture(width, height, 2 * width + (c % 2 ? 6 : 0), data, encoding);
    colour::yuv_from_bgr(frame, yuv.pictures[c]);
  }
  return yuv;
}

synthesis::ToneMapping smooth_tone_mapping(bool falloff) {
  synthesis::ToneMapping mapping = synthesis::ToneMapping::identity();
  for (int c = 0; c < 4; ++c) {
    for (int channel = 0; channel < synthesis::kChannels; ++channel)
      for (int i = 0; i < 256; ++i)
        mapping.curves[c][channel][i] =
            static_cast<uint8_t>(std::lround(255 * std::pow(i / 255.0, 0.7 + 0.15 * c + 0.05 * channel)));
    if (falloff) mapping.falloff[c] = {900 + 100 * c, -120};
  }
  return mapping;
}

std::unique_ptr<gl::BowlRenderer> renderer_of_parking(const gl::GlContext& context) {
  auto renderer = std::make_unique<gl::BowlRenderer>(context, kPicture);
  renderer->set_mesh(parking().mesh.table(), parking().rig);
  return renderer;
}

cv::Mat drawn(gl::BowlRenderer& renderer, const Frames& frames, const synthesis::ToneMapping& tone_mapping,
              const bowl::Viewpoint& viewpoint, float car_opacity) {
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
  renderer.render(frames.pictures, tone_mapping, viewpoint, car_opacity, colour::bgr_picture(picture));
  return picture;
}

cv::Mat expected(const Frames& frames, const synthesis::ToneMapping& tone_mapping,
                 const bowl::Viewpoint& viewpoint, float car_opacity, cv::Rect* car_at) {
  const Parking& world = parking();
  std::vector<std::byte> memory(bowl::ViewpointLut::capacity(kPicture));
  bowl::ViewpointLut maker(world.rig, world.surface, {});
  const size_t bytes = maker.build(viewpoint, kPicture, memory);
  const synthesis::GeometricLut lut{std::span<const std::byte>(memory).first(bytes)};
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
  synthesize(lut, frames.pictures, tone_mapping, colour::bgr_picture(picture), nullptr);
  if (car_opacity <= 0) return picture;
  car::CarPicture car(world.car, world.rig.vehicle);
  car.render(car::seen_from(viewpoint, kPicture), car_opacity);
  car.blend_over(picture);
  if (car_at) *car_at = car.rectangle();
  return picture;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(3 * a.total());
}

}  // namespace svchain::testing
