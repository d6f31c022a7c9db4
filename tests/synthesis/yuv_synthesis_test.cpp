// Synthesis from NV12 and YUYV, and into NV12, against the way by whole pictures in BGR.

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "algorithms/colour/convert.h"
#include "algorithms/synthesis/synthesize.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/synthesis/decoded_lut.h"
#include "tests/synthesis/four_cameras.h"

using namespace svchain;
using namespace svchain::synthesis;
using namespace svchain::testing;
using colour::Picture;
using colour::PixelFormat;
using colour::YuvEncoding;

namespace {

const cv::Size kImage(320, 180);
const cv::Size kView(202, 244);  // its last blocks are not whole

Picture yuv_picture(PixelFormat format, cv::Mat& bytes, cv::Size size, YuvEncoding encoding) {
  const bool nv12 = format == PixelFormat::kNv12;
  if (nv12) bytes.create(size.height * 3 / 2, size.width, CV_8U);
  if (!nv12) bytes.create(size.height, size.width * 2, CV_8U);
  const auto view = nv12 ? colour::nv12_picture : colour::yuyv_picture;
  return view(size.width, size.height, bytes.step[0], bytes.data, encoding);
}

/// Colours as cameras give them: edges that a lens has softened, nowhere brighter or more colourful than the
/// encodings hold.
cv::Mat soft_frame(uint64_t seed) {
  cv::Mat coarse(kImage.height / 8, kImage.width / 8, CV_8UC3), frame;
  cv::RNG(seed).fill(coarse, cv::RNG::UNIFORM, 70, 186);
  cv::resize(coarse, frame, kImage, 0, 0, cv::INTER_CUBIC);
  return frame;
}

/// Four frames in YUV, and the same four converted to BGR as a whole.
struct Frames {
  Frames(PixelFormat format, YuvEncoding encoding, bool random = false, cv::Size size = kImage) {
    for (size_t c = 0; c < 4; ++c) {
      yuv[c] = yuv_picture(format, bytes[c], size, encoding);
      if (random) cv::RNG(c + 9).fill(bytes[c], cv::RNG::UNIFORM, 0, 256);
      if (!random) colour::yuv_from_bgr(colour::bgr_picture(soft_frame(c + 1)), yuv[c]);
      bgr[c].create(size, CV_8UC3);
      colour::bgr_from_yuv(yuv[c], colour::bgr_picture(bgr[c]));
    }
  }
  std::array<cv::Mat, 4> bytes, bgr;
  std::array<Picture, 4> yuv;
};

struct Car {
  geometry::Rig rig = four_cameras({kImage.width, kImage.height});
  geometry::View view = view_of(rig, {kView.width, kView.height});
  OwnedLut owned{rig, view};
  GeometricLut lut = owned.lut();
  std::vector<std::byte> memory = std::vector<std::byte>(OverlapStatistics::bytes_for(view));
  OverlapStatistics* statistics = OverlapStatistics::create(memory);

  cv::Mat composite(std::span<const Picture> frames, const ToneMapping& mapping = ToneMapping::identity()) {
    cv::Mat out(kView, CV_8UC3);
    synthesize(lut, frames, mapping, colour::bgr_picture(out), statistics);
    return out;
  }
  cv::Mat composite(const std::array<cv::Mat, 4>& frames) {
    cv::Mat out(kView, CV_8UC3);
    synthesize(lut, frames, ToneMapping::identity(), out, statistics);
    return out;
  }
};

ToneMapping some_tone_mapping() {
  ToneMapping mapping = ToneMapping::identity();
  for (size_t v = 0; v < 256; ++v) mapping.curves[2][1][v] = static_cast<uint8_t>(255 - v);
  mapping.falloff[1] = {kRadialOne / 4, kRadialOne / 8};
  return mapping;
}

std::vector<BlockSamples> samples_of(const OverlapStatistics& statistics) {
  std::vector<BlockSamples> all;
  for (const OverlapBlock& block : statistics.blocks()) all.insert(all.end(), {block.a, block.b});
  return all;
}

}  // namespace

TEST_CASE("frames in YUV give the composite and statistics of the same frames in BGR, in every encoding") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  const auto encoding = static_cast<YuvEncoding>(GENERATE(0, 1, 2, 3));
  const bool random = GENERATE(false, true);  // bytes that no camera gives, too
  Car car;
  const Frames frames(format, encoding, random);
  const cv::Mat expected = car.composite(frames.bgr);
  const auto expected_samples = samples_of(*car.statistics);
  const cv::Mat got = car.composite(frames.yuv);
  CHECK(cv::norm(expected, got, cv::NORM_INF) == 0);
  CHECK(samples_of(*car.statistics) == expected_samples);
}

TEST_CASE("blocks that see too much to be converted show the same") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  const cv::Size image(960, 600), view_px(60, 72);  // a block takes half a picture
  const geometry::Rig rig = four_cameras({image.width, image.height});
  const OwnedLut owned(rig, view_of(rig, {view_px.width, view_px.height}));
  const Frames frames(format, YuvEncoding::kBt601Limited, true, image);
  cv::Mat expected(view_px, CV_8UC3), got(view_px, CV_8UC3);
  synthesize(owned.lut(), frames.bgr, ToneMapping::identity(), expected, nullptr);
  synthesize(owned.lut(), frames.yuv, ToneMapping::identity(), colour::bgr_picture(got), nullptr);
  CHECK(cv::norm(expected, got, cv::NORM_INF) == 0);
}

TEST_CASE("cameras may differ in format and encoding") {
  Car car;
  Frames frames(PixelFormat::kNv12, YuvEncoding::kBt601Limited);
  const Frames others(PixelFormat::kYuyv, YuvEncoding::kBt709Full);
  frames.yuv[1] = others.yuv[1];
  frames.bgr[1] = others.bgr[1];
  frames.yuv[3] = colour::bgr_picture(frames.bgr[3]);
  CHECK(cv::norm(car.composite(frames.bgr), car.composite(frames.yuv), cv::NORM_INF) == 0);
}

TEST_CASE("a missing camera is a black one among frames in YUV too") {
  Car car;
  Frames frames(PixelFormat::kNv12, YuvEncoding::kBt709Limited);
  cv::Mat bytes;
  const Picture black = yuv_picture(PixelFormat::kNv12, bytes, kImage, YuvEncoding::kBt709Limited);
  colour::yuv_from_bgr(colour::bgr_picture(cv::Mat::zeros(kImage, CV_8UC3)), black);
  frames.yuv[2] = black;
  const cv::Mat expected = car.composite(frames.yuv);
  frames.yuv[2] = {};
  CHECK(cv::norm(expected, car.composite(frames.yuv), cv::NORM_INF) == 0);
}

TEST_CASE("a composite in NV12 is byte by byte the one in BGR, converted, in every encoding") {
  Car car;
  const auto encoding = static_cast<YuvEncoding>(GENERATE(0, 1, 2, 3));
  const ToneMapping mapping = some_tone_mapping();
  const Frames frames(PixelFormat::kYuyv, YuvEncoding::kBt601Full);
  const cv::Mat bgr = car.composite(frames.yuv, mapping);
  cv::Mat expected, canvas(kView.height * 3 / 2, kView.width + 14, CV_8U, cv::Scalar(5));
  colour::yuv_from_bgr(colour::bgr_picture(bgr), yuv_picture(PixelFormat::kNv12, expected, kView, encoding));
  const Picture out = colour::nv12_picture(kView.width, kView.height, canvas.step[0], canvas.data, encoding);
  synthesize(car.lut, frames.yuv, mapping, out, nullptr);
  CHECK(cv::norm(expected, canvas.colRange(0, kView.width), cv::NORM_INF) == 0);
  CHECK(cv::countNonZero(canvas.colRange(kView.width, canvas.cols) != 5) == 0);
}

TEST_CASE("synthesis from and to YUV allocates nothing, whatever bytes come") {
  const auto format = GENERATE(PixelFormat::kNv12, PixelFormat::kYuyv);
  Car car;
  const Frames frames(format, YuvEncoding::kBt601Limited, true);
  cv::Mat bytes;
  const Picture out = yuv_picture(PixelFormat::kNv12, bytes, kView, YuvEncoding::kBt601Limited);
  const ToneMapping mapping = some_tone_mapping();
  const size_t before = allocation_count();
  synthesize(car.lut, frames.yuv, mapping, out, car.statistics);
  CHECK(allocation_count() == before);
}

TEST_CASE("NV12 out of a view of odd size, and YUYV out of any, are refused before the first pixel") {
  Car car;
  const Frames frames(PixelFormat::kNv12, YuvEncoding::kBt601Limited);
  cv::Mat bytes(400, 500, CV_8U, cv::Scalar(5));
  const auto refused = [&](const GeometricLut& lut, const Picture& out, const std::string& why) {
    CHECK_THROWS_WITH(synthesize(lut, frames.yuv, ToneMapping::identity(), out, nullptr),
                      Catch::Matchers::Contains(why));
    CHECK(cv::countNonZero(bytes != 5) == 0);
  };
  const OwnedLut odd(car.rig, view_of(car.rig, {201, 243}));
  refused(odd.lut(), colour::nv12_picture(201, 243, 500, bytes.data, {}), "even width and height");
  refused(car.lut, colour::yuyv_picture(202, 244, 500, bytes.data, {}), "neither BGR, BGRX nor NV12");
  refused(car.lut, colour::nv12_picture(204, 244, 500, bytes.data, {}), "the view's size");
}
