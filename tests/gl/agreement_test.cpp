#include "algorithms/bowl/viewpoint_presets.h"
#include "tests/catch.h"
#include "tests/gl/parking.h"

using namespace svchain;
using namespace svchain::testing;
using colour::PixelFormat;
using colour::YuvEncoding;

TEST_CASE("the GPU's bowl is the CPU's within two levels from every preset, tone mapping included") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  for (const bool falloff : {false, true}) {
    const auto tone_mapping = smooth_tone_mapping(falloff);
    for (const std::string& name : bowl::preset_names()) {
      const bowl::Viewpoint viewpoint = parking().preset(name);
      const cv::Mat gpu = drawn(*renderer, parking().bgr, tone_mapping, viewpoint);
      const cv::Mat cpu = expected(parking().bgr, tone_mapping, viewpoint);
      CAPTURE(name, falloff);
      CHECK(mean_difference(gpu, cpu) < 2);
      // And that is little: without the curves it is far more.
      const cv::Mat bare = drawn(*renderer, parking().bgr, synthesis::ToneMapping::identity(), viewpoint);
      CHECK(mean_difference(bare, cpu) > 5);
    }
  }
}

TEST_CASE("the GPU takes NV12 and YUYV as the CPU does, in every encoding") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const auto tone_mapping = smooth_tone_mapping(false);
  const bowl::Viewpoint chase = parking().preset("chase");
  for (const PixelFormat format : {PixelFormat::kNv12, PixelFormat::kYuyv})
    for (const YuvEncoding encoding : {YuvEncoding::kBt601Limited, YuvEncoding::kBt601Full,
                                       YuvEncoding::kBt709Limited, YuvEncoding::kBt709Full}) {
      const Frames frames = in_yuv(parking().bgr, format, encoding);
      const cv::Mat gpu = drawn(*renderer, frames, tone_mapping, chase);
      CAPTURE(static_cast<int>(format), static_cast<int>(encoding));
      CHECK(mean_difference(gpu, expected(frames, tone_mapping, chase)) < 2);
      const cv::Mat bgr = drawn(*renderer, parking().bgr, tone_mapping, chase);
      CHECK(mean_difference(gpu, bgr) < 1.5);  // what conversion takes from noise
    }
}

TEST_CASE("the GPU takes cameras of different formats at once, and a camera that gave nothing as black") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const auto tone_mapping = smooth_tone_mapping(true);
  const Frames nv12 = in_yuv(parking().bgr, PixelFormat::kNv12, YuvEncoding::kBt709Limited);
  const Frames yuyv = in_yuv(parking().bgr, PixelFormat::kYuyv, YuvEncoding::kBt601Full);
  Frames mixed = parking().bgr;
  mixed.pictures[1] = nv12.pictures[1];
  mixed.pictures[2] = yuyv.pictures[2];
  const bowl::Viewpoint top = parking().preset("top");
  CHECK(mean_difference(drawn(*renderer, mixed, tone_mapping, top), expected(mixed, tone_mapping, top)) < 2);
  for (const size_t missing : {0u, 1u, 2u}) {
    mixed.pictures[missing] = {};
    CHECK(mean_difference(drawn(*renderer, mixed, tone_mapping, top), expected(mixed, tone_mapping, top)) <
          2);
  }
}

TEST_CASE("from beyond the rim the GPU shows the bowl's outside black, as the CPU does") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const auto tone_mapping = smooth_tone_mapping(false);
  const bowl::BowlSurface& surface = parking().surface;
  const bowl::Viewpoint outside{
      {surface.floor_length_m / 2 + 1.6 * surface.rise_m, 0, 1.3 * surface.height_m},
      {0, 0, 0},
      {0, 0, 1},
      60};
  const cv::Mat gpu = drawn(*renderer, parking().bgr, tone_mapping, outside);
  const cv::Mat cpu = expected(parking().bgr, tone_mapping, outside);
  CHECK(mean_difference(gpu, cpu) < 2);
  CHECK(mean_difference(gpu, cv::Mat::zeros(gpu.size(), gpu.type())) > 5);
  // The wall is in the lower part.
  CHECK(cv::norm(gpu.rowRange(gpu.rows * 9 / 10, gpu.rows), cv::NORM_INF) == 0);
}
