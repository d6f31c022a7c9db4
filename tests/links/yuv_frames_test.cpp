// Frames in NV12 and YUYV on their way: from the cameras, through what only hands them on, to the display.

#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "algorithms/colour/convert.h"
#include "links/display/display.h"
#include "links/dup.h"
#include "links/gate.h"
#include "links/image.h"
#include "links/merge.h"
#include "links/select.h"
#include "links/shown_frame.h"
#include "links/sync/sync.h"
#include "tests/catch.h"
#include "tests/links/capture_harness.h"
#include "tests/links/pictures.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

Format yuv_format(const std::string& type, cv::Size size, const std::string& colour) {
  return (type == "nv12" ? Format::nv12 : Format::yuyv)(size.width, size.height, colour);
}

/// The bytes of a picture in another format.
std::vector<std::byte> encoded(const cv::Mat& bgr, const Format& format) {
  std::vector<std::byte> bytes(format.bytes);
  colour::yuv_from_bgr(colour::bgr_picture(bgr), any_picture(format, bytes.data()));
  return bytes;
}

/// What is left of a picture that went that way.
cv::Mat decoded(const cv::Mat& bgr, const Format& format) {
  std::vector<std::byte> bytes = encoded(bgr, format);
  cv::Mat back(bgr.size(), CV_8UC3);
  colour::bgr_from_yuv(any_picture(format, bytes.data()), colour::bgr_picture(back));
  return back;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

const cv::Size kSize(8, 6);

}  // namespace

TEST_CASE("formats in YUV say how many bytes they take, every row beginning at a multiple of 64") {
  const Format nv12 = Format::nv12(70, 40, "bt601_full");
  CHECK(nv12.pitch_bytes == 128);
  CHECK(nv12.bytes == 128 * (40 + 20));
  const Format yuyv = Format::yuyv(70, 41, "bt601_full");
  CHECK(yuyv.pitch_bytes == 192);
  CHECK(yuyv.bytes == 192 * 41);
  CHECK(nv12 != Format::nv12(70, 40, "bt601_limited"));
  CHECK(Format::bgr8(70, 40).colour.empty());
}

TEST_CASE("a capture gives NV12 or YUYV in the encoding that is asked for, of stills once for all") {
  const std::string type = GENERATE("nv12", "yuyv"), colour = GENERATE("bt601_limited", "bt709_full");
  TemporaryFolder folder;
  write_stills(folder.path());
  CaptureAlone capture(folder.path().string());
  capture.parameter("format", type);
  capture.parameter("colour", colour);
  REQUIRE(text_of(capture.configure()) == "");
  const Format format = yuv_format(type, kSize, colour);
  CHECK(capture.output_format("left") == PortFormat{format});
  capture.run();
  const std::byte* first = nullptr;
  for (int n = 0; n < 30; ++n) {
    const auto left = capture.pop("left");
    REQUIRE(left);
    if (!first) first = left->bytes().data();
    CHECK(left->bytes().data() == first);
    CHECK(same(ShownFrame().of(*left), decoded(numbered_picture(3, 0), format)));
  }
}

TEST_CASE("YUV is BT.601 in the limited range where nothing else is asked for") {
  TemporaryFolder folder;
  write_stills(folder.path());
  CaptureAlone capture(folder.path().string());
  capture.parameter("format", "nv12");
  REQUIRE(text_of(capture.configure()) == "");
  CHECK(capture.output_format("front").front() == Format::nv12(8, 6, "bt601_limited"));
}

TEST_CASE("numbered frames and videos are given in NV12 one by one") {
  TemporaryFolder folder;
  const bool video = GENERATE(true, false);
  const char* names[] = {"front", "right", "rear", "left"};
  if (video)
    for (int c = 0; c < 4; ++c) write_video(folder.path() / (std::string(names[c]) + ".mkv"), c, 3);
  if (!video) write_numbered(folder.path(), 3);
  CaptureAlone capture(folder.path().string());
  capture.parameter("format", "nv12");
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  CHECK(capture.failure() == "");
  const Format format = Format::nv12(8, 6, "bt601_limited");
  for (int n = 0; n < 3; ++n) {
    const auto rear = capture.pop("rear");
    REQUIRE(rear);
    CHECK(same(ShownFrame().of(*rear), decoded(numbered_picture(2, n), format)));
  }
  CHECK(capture.pop_end("rear"));
}

TEST_CASE("simulated cameras give the same NV12 in real time and without") {
  const auto first_frame = [](bool real_time) {
    CaptureAlone capture("simulated:toy");
    capture.pace.frames = 1;
    capture.pace.real_time = real_time;
    capture.parameter("format", "nv12");
    REQUIRE(text_of(capture.configure()) == "");
    capture.run(1);
    const auto right = capture.pop("right");
    REQUIRE(right);
    return ShownFrame().of(*right).clone();
  };
  const cv::Mat expected = first_frame(false);
  CHECK(cv::mean(expected)[1] > 20);
  CHECK(same(first_frame(true), expected));
}

TEST_CASE("a colour encoding for bgr8, and pictures with half a group, are faults") {
  TemporaryFolder folder;
  write_stills(folder.path(), {9, 7});
  CaptureAlone plain(folder.path().string());
  plain.parameter("colour", "bt709_full");
  CHECK_THAT(text_of(plain.configure()),
             Contains("\"colour\"") && Contains("nv12 or yuyv") && Contains("the format is bgr8"));
  CaptureAlone odd(folder.path().string());
  odd.parameter("format", "nv12");
  CHECK_THAT(text_of(odd.configure()), Contains("nv12 needs an even width and height") &&
                                           Contains("\"front\" is 9x7") && Contains("\"left\" is 9x7"));
}

TEST_CASE("links that hand frames on leave format, encoding and bytes as they are") {
  const Format format = Format::nv12(8, 6, "bt709_full");
  LinkHarness sync(make_sync()), dup(make_dup()), select(make_select()), merge(make_merge()),
      gate(make_gate());
  for (const char* camera : {"front", "right", "rear", "left"}) sync.input(camera, {format});
  dup.input("in", PortFormat(4, format));
  select.input("in", PortFormat(4, format));
  select.parameter("buffers", {2, 0});
  merge.input("in0", {format});
  merge.input("in1", PortFormat(2, format));
  gate.input("in", {format});
  for (LinkHarness* link : {&sync, &dup, &select, &merge, &gate}) REQUIRE(text_of(link->configure()) == "");
  CHECK(sync.output_format("frames") == PortFormat(4, format));
  CHECK(dup.output_format("out3") == PortFormat(4, format));
  CHECK(select.output_format("out") == PortFormat(2, format));
  CHECK(merge.output_format("frames") == PortFormat(3, format));
  CHECK(gate.output_format("out") == PortFormat{format});

  const auto bytes = encoded(numbered_picture(1, 2), format);
  for (const char* camera : {"front", "right", "rear", "left"})
    sync.push(camera, {.write = [&](int, std::span<std::byte> to) {
                std::copy(bytes.begin(), bytes.end(), to.begin());
              }});
  sync.run();
  const auto set = sync.pop("frames");
  REQUIRE(set);
  for (int camera = 0; camera < 4; ++camera) {
    CHECK(set->format(camera) == format);
    CHECK(std::equal(bytes.begin(), bytes.end(), set->bytes(camera).begin(), set->bytes(camera).end()));
  }
}

TEST_CASE("a display shows, writes and sums up what frames in YUV look like") {
  const std::string type = GENERATE("nv12", "yuyv");
  const Format format = yuv_format(type, {30, 20}, "bt709_limited");
  const auto deliver = [](const Format& f, const std::filesystem::path& path, const auto& bytes_of) {
    LinkHarness display(make_display());
    display.setting("output", path.string());
    display.parameter("sha256", true);
    display.input("frames", {f});
    REQUIRE(text_of(display.configure()) == "");
    for (int n = 0; n < 3; ++n) {
      display.push("frames",
                   {.sequence = static_cast<uint64_t>(n), .write = [&](int, std::span<std::byte> to) {
                      const auto bytes = bytes_of(n);
                      std::copy(bytes.begin(), bytes.end(), to.begin());
                    }});
      display.run();
    }
    display.stop();
    return display.report()["output"]["sha256"].get<std::string>();
  };
  const auto shown = [&](int n) { return decoded(numbered_picture(9, 40 * n, {30, 20}), format); };
  const Format bgr = Format::bgr8(30, 20);
  const auto in_yuv = [&](int n) { return encoded(numbered_picture(9, 40 * n, {30, 20}), format); };
  const auto in_bgr = [&](int n) {
    std::vector<std::byte> bytes(bgr.bytes);
    shown(n).copyTo(bgr_picture(bgr, bytes.data()));
    return bytes;
  };
  TemporaryFolder folder;
  const auto last = folder.path() / "last.png", all = folder.path() / "all";
  const std::string sha = deliver(bgr, folder.path() / "bgr.mkv", in_bgr);
  CHECK(deliver(format, last, in_yuv) == sha);
  CHECK(deliver(format, all, in_yuv) == sha);
  CHECK(deliver(format, folder.path() / "yuv.mkv", in_yuv) == sha);
  CHECK(same(cv::imread(last.string()), shown(2)));
  CHECK(same(cv::imread((all / "000001.png").string()), shown(1)));
}

TEST_CASE("an encoding that nobody knows is a fault with those there are") {
  LinkHarness display(make_display());
  display.setting("output", "none");
  display.input("frames", {Format::nv12(30, 20, "bt2020")});
  CHECK_THAT(text_of(display.configure()), Contains("colour") && Contains("gives \"bt2020\"") &&
                                               Contains("takes bt601_limited, bt601_full"));
}
