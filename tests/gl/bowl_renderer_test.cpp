#include "algorithms/gl/bowl_renderer.h"

#include <thread>

#include "algorithms/gl/packed_bgr.h"
#include "tests/allocation_count.h"
#include "tests/catch.h"
#include "tests/gl/parking.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const synthesis::ToneMapping kTones = smooth_tone_mapping(false);

}  // namespace

TEST_CASE("a mesh table for another rig is refused, and what differs is named") {
  if (!has_gl()) return;
  const gl::GlContext context;
  gl::BowlRenderer renderer(context, kPicture);
  geometry::Rig rig = parking().rig;
  const OwnedMesh small(four_cameras({640, 360}), parking().surface, {}, 3);
  CHECK_THROWS_WITH(renderer.set_mesh(small.table(), rig), Contains("1280 x 720 px") &&
                                                               Contains("made for 640 x 360 px") &&
                                                               Contains("\"" + rig.cameras[0].name + "\""));
  rig.cameras[2].vehicle_from_camera.translation.x() += 0.01;
  CHECK_THROWS_WITH(renderer.set_mesh(parking().mesh.table(), rig), Contains("another rig"));
  rig.cameras.pop_back();
  CHECK_THROWS_WITH(renderer.set_mesh(parking().mesh.table(), rig), Contains("four cameras, got 3"));
}

TEST_CASE("what the GL renderer cannot draw from or into is refused and named") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const bowl::Viewpoint top = parking().preset("top");
  gl::BowlRenderer bare(context, kPicture);
  CHECK_THROWS_WITH(drawn(bare, parking().bgr, kTones, top), Contains("no mesh table yet"));
  CHECK_THROWS_AS(gl::BowlRenderer(context, Eigen::Vector2i(0, 5)), std::invalid_argument);
  CHECK_THROWS_WITH(gl::BowlRenderer(context, Eigen::Vector2i(1 << 20, 5)), Contains("at most"));

  const auto renderer = renderer_of_parking(context);
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3), other(kPicture.x(), kPicture.y(), CV_8UC3);
  const auto render = [&](std::span<const colour::Picture> frames, const cv::Mat& into) {
    renderer->render(frames, kTones, top, 1, colour::bgr_picture(into));
  };
  Frames frames = parking().bgr;
  CHECK_THROWS_WITH(render(frames.pictures, other), Contains("330 x 405 px") && Contains("got 405 x 330 px"));
  CHECK_THROWS_WITH(render(std::span(frames.pictures).first(3), picture), Contains("four frames, got 3"));
  frames.pictures[2].width_px = 640;
  CHECK_THROWS_WITH(render(frames.pictures, picture),
                    Contains("camera 2 has 640 x 720 px") && Contains("1280 x 720 px"));
}

TEST_CASE("a picture of rows with gaps gets its pixels, and its gaps keep theirs") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const bowl::Viewpoint chase = parking().preset("chase");
  const cv::Mat whole = drawn(*renderer, parking().bgr, kTones, chase);
  cv::Mat canvas(kPicture.y() + 2, kPicture.x() + 2, CV_8UC3, cv::Scalar(1, 2, 3));
  cv::Mat inner = canvas(cv::Rect(1, 1, kPicture.x(), kPicture.y()));
  renderer->render(parking().bgr.pictures, kTones, chase, 0, colour::bgr_picture(inner));
  CHECK(cv::norm(inner, whole, cv::NORM_INF) == 0);
  inner.setTo(cv::Scalar(1, 2, 3));
  CHECK(cv::norm(canvas, cv::Mat(canvas.size(), CV_8UC3, cv::Scalar(1, 2, 3)), cv::NORM_INF) == 0);
}

TEST_CASE("frames whose rows have gaps are read without them") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  const bowl::Viewpoint chase = parking().preset("chase");
  Frames gaps;
  for (size_t c = 0; c < 4; ++c) {
    const cv::Mat& frame = parking().bgr.memory[c];
    gaps.memory[c].create(frame.rows, frame.cols + 5, CV_8UC3);
    gaps.memory[c].setTo(cv::Scalar(255, 0, 255));
    frame.copyTo(gaps.memory[c](cv::Rect(0, 0, frame.cols, frame.rows)));
    gaps.pictures[c] = colour::bgr_picture(gaps.memory[c](cv::Rect(0, 0, frame.cols, frame.rows)));
  }
  CHECK(cv::norm(drawn(*renderer, gaps, kTones, chase), drawn(*renderer, parking().bgr, kTones, chase),
                 cv::NORM_INF) == 0);
}

TEST_CASE("upload, draw and read-back one after the other make the picture that render makes") {
  if (!has_gl()) return;
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  renderer->set_car(parking().car, parking().rig.vehicle);
  const bowl::Viewpoint chase = parking().preset("chase"), top = parking().preset("top");
  const cv::Mat whole = drawn(*renderer, parking().bgr, kTones, chase, 1);
  static_cast<void>(drawn(*renderer, parking().bgr, kTones, top, 1));  // so that the car is drawn anew
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3), black = picture.clone();
  renderer->upload(parking().bgr.pictures);
  renderer->draw(kTones, chase, 1);
  renderer->read_back(colour::bgr_picture(picture));
  CHECK(cv::norm(picture, whole, cv::NORM_INF) == 0);

  gl::BowlRenderer bare(context, kPicture);
  CHECK_THROWS_WITH(bare.upload(parking().bgr.pictures), Contains("no mesh table yet"));
  CHECK_THROWS_WITH(bare.draw(kTones, chase, 1), Contains("no mesh table yet"));
  const auto without_frames = renderer_of_parking(context);
  without_frames->draw(kTones, chase, 0);
  without_frames->read_back(colour::bgr_picture(black));
  CHECK(cv::norm(black, cv::NORM_INF) == 0);
}

TEST_CASE("two GL renderers on two threads each draw what one alone draws") {
  if (!has_gl()) return;
  const std::array<bowl::Viewpoint, 2> viewpoints = {parking().preset("chase"), parking().preset("top")};
  std::array<cv::Mat, 2> alone;
  std::array<bool, 2> same = {false, false};
  const auto draw = [&](size_t i) {
    const gl::GlContext context;
    const auto renderer = renderer_of_parking(context);
    renderer->set_car(parking().car, parking().rig.vehicle);
    cv::Mat picture;
    for (int frame = 0; frame < 4; ++frame)
      picture = drawn(*renderer, parking().bgr, kTones, viewpoints[i], 1);
    return picture;
  };
  for (size_t i = 0; i < 2; ++i) alone[i] = draw(i);
  const auto draw_and_compare = [&](size_t i) { same[i] = cv::norm(draw(i), alone[i], cv::NORM_INF) == 0; };
  std::thread first(draw_and_compare, 0), second(draw_and_compare, 1);
  first.join();
  second.join();
  CHECK(same[0]);
  CHECK(same[1]);
  CHECK(mean_difference(alone[0], alone[1]) > 5);
}

TEST_CASE("a GL renderer made by one thread serves another, and goes in a third") {
  if (!has_gl()) return;
  const gl::GlContext context;
  auto renderer = renderer_of_parking(context);
  const bowl::Viewpoint top = parking().preset("top");
  const cv::Mat here = drawn(*renderer, parking().bgr, kTones, top);
  cv::Mat there;
  std::thread([&] { there = drawn(*renderer, parking().bgr, kTones, top); }).join();
  std::thread([&] { renderer.reset(); }).join();
  CHECK(cv::norm(here, there, cv::NORM_INF) == 0);
}

TEST_CASE("a frame like the one before costs the GL renderer no allocation of its own") {
  if (!has_gl()) return;
  const auto car_by = GENERATE(gl::CarDrawnBy::kGl, gl::CarDrawnBy::kCpu);
  const gl::GlContext context;
  const auto renderer = renderer_of_parking(context);
  renderer->set_car(parking().car, parking().rig.vehicle, car_by);
  const Frames nv12 = in_yuv(parking().bgr, colour::PixelFormat::kNv12, colour::YuvEncoding::kBt601Limited);
  cv::Mat picture(kPicture.y(), kPicture.x(), CV_8UC3);
  const colour::Picture out = colour::bgr_picture(picture);
  const bowl::Viewpoint top = parking().preset("top");
  for (const Frames* frames : {&parking().bgr, &nv12}) {
    for (int i = 0; i < 3; ++i) renderer->render(frames->pictures, kTones, top, 1, out);
    const size_t before = allocation_count();  // drivers that call operator new count too
    for (int i = 0; i < 3; ++i) renderer->render(frames->pictures, kTones, top, 1, out);
    CHECK(allocation_count() == before);
  }
}

TEST_CASE(
    "pixels of three bytes become pixels of four and come back, and nothing beyond the row is touched") {
  for (const size_t count : {0u, 1u, 2u, 7u}) {
    std::vector<uint8_t> bgr(3 * count);
    for (size_t i = 0; i < bgr.size(); ++i) bgr[i] = static_cast<uint8_t>(11 * i + 1);
    std::vector<uint32_t> pixels(count);
    gl::unpack_bgr(bgr.data(), count, pixels.data());
    for (size_t i = 0; i < count; ++i) {
      const auto* const bytes = reinterpret_cast<const uint8_t*>(&pixels[i]);
      for (size_t c = 0; c < 3; ++c) CHECK(bytes[c] == bgr[3 * i + c]);
    }
    std::vector<uint8_t> back(3 * count + 1, 77);
    gl::pack_bgr(pixels.data(), count, back.data());
    CHECK(std::equal(bgr.begin(), bgr.end(), back.begin()));
    CHECK(back.back() == 77);
  }
}
