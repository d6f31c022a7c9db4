#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "tests/catch.h"
#include "tests/links/capture_harness.h"
#include "tests/links/pictures.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;

TEST_CASE("stills are sent thirty times from the same buffers with rising sequence and time stamps") {
  TemporaryFolder folder;
  write_stills(folder.path());
  CaptureAlone capture(folder.path().string());
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  CHECK(capture.captured() == 30);
  const std::byte* first = nullptr;
  for (uint64_t n = 0; n < 30; ++n) {
    const auto right = capture.pop("right");
    REQUIRE(right);
    CHECK(right->sequence() == n);
    CHECK(right->timestamp_ns() == std::llround(static_cast<double>(n) * 1e9 / 30));
    CHECK(pixel(*right, 5, 2) == cv::Vec3b(1, 0, 5));
    if (!first) first = right->bytes().data();
    CHECK(right->bytes().data() == first);
  }
  CHECK(capture.pop_end("right"));
}

TEST_CASE("stills let go of their buffers when the capture stops") {
  TemporaryFolder folder;
  write_stills(folder.path());
  CaptureAlone capture(folder.path().string());
  capture.pace.frames = 2;
  REQUIRE(capture.configure().empty());
  capture.run();
  while (drop_set(capture)) continue;
  capture.stop();
  CHECK(capture.buffers_in_use() == 0);
}

TEST_CASE("the number of sets asked for overrides how often stills are sent") {
  TemporaryFolder folder;
  write_stills(folder.path());
  CaptureAlone capture(folder.path().string());
  capture.pace.frames = 7;
  REQUIRE(capture.configure().empty());
  capture.run();
  CHECK(capture.captured() == 7);
}

TEST_CASE("back is taken for rear, and cameras may differ in file type and size") {
  TemporaryFolder folder;
  write_picture(folder.path() / "front.bmp", numbered_picture(0, 0));
  write_picture(folder.path() / "right.jpg", numbered_picture(1, 0, {16, 10}));
  write_picture(folder.path() / "BACK.PNG", numbered_picture(2, 0));
  write_picture(folder.path() / "left.jpeg", numbered_picture(3, 0));
  CaptureAlone capture(folder.path().string());
  REQUIRE(text_of(capture.configure()) == "");
  CHECK(capture.output_format("right").front() == Format::bgr8(16, 10));
  capture.run(1);
  const auto rear = capture.pop("rear");
  REQUIRE(rear);
  CHECK(pixel(*rear, 3, 3) == cv::Vec3b(2, 0, 3));
}

TEST_CASE("numbered frames come in the order of their numbers, to their end") {
  TemporaryFolder folder;
  for (const char* camera : {"front", "right", "rear", "left"}) {
    for (int n : {0, 1, 2, 9, 10, 11}) {
      write_picture(folder.path() / camera / ("f" + std::to_string(n) + ".png"), numbered_picture(0, n));
    }
  }
  CaptureAlone capture(folder.path().string());
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  for (int n : {0, 1, 2, 9, 10, 11}) {
    const auto front = capture.pop("front");
    REQUIRE(front);
    CHECK(pixel(*front, 0, 0)[1] == n);
  }
  CHECK(capture.pop_end("front"));
  CHECK(capture.captured() == 6);
}

TEST_CASE("fewer frames than there are can be asked for, more cannot") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 4);
  const auto [asked, got] = GENERATE(table<uint64_t, uint64_t>({{2, 2}, {9, 4}}));
  CaptureAlone capture(folder.path().string());
  capture.pace.frames = asked;
  REQUIRE(capture.configure().empty());
  capture.run();
  CHECK(capture.captured() == got);
}

TEST_CASE("four videos are read to their end, pixel by pixel") {
  TemporaryFolder folder;
  const char* names[] = {"front", "right", "rear", "left"};
  for (int c = 0; c < 4; ++c) write_video(folder.path() / (std::string(names[c]) + ".mkv"), c, 5);
  CaptureAlone capture(folder.path().string());
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  CHECK(capture.failure() == "");
  for (int n = 0; n < 5; ++n) {
    const auto left = capture.pop("left");
    REQUIRE(left);
    CHECK(pixel(*left, 7, 5) == cv::Vec3b(3, static_cast<uchar>(n), 7));
  }
  CHECK(capture.pop_end("left"));
}

TEST_CASE("a lossless capture waits for room and drops nothing") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 5);
  CaptureAlone capture(folder.path().string());
  capture.output_depth("left", 1);
  REQUIRE(capture.configure().empty());
  uint64_t sets = 0;
  while (capture.run() > 0) {
    while (drop_set(capture)) ++sets;
  }
  CHECK(sets == 5);
  CHECK(capture.dropped().empty());
}

TEST_CASE("a lossless capture keeps the nominal rate on a virtual clock") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 3);
  CaptureAlone capture(folder.path().string());
  capture.pace.virtual_clock = true;
  capture.pace.fps = 10;
  REQUIRE(capture.configure().empty());
  capture.run();
  CHECK(capture.captured() == 1);
  CHECK(capture.wake_time_ns() == 100'000'000);
  capture.clock().advance_to(100'000'000);
  capture.run();
  CHECK(capture.captured() == 2);
}

TEST_CASE("in real time a set that finds no room is dropped and counted") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 4);
  CaptureAlone capture(folder.path().string());
  capture.pace.real_time = capture.pace.virtual_clock = true;
  capture.pace.fps = 10;
  capture.output_depth("rear", 1);
  REQUIRE(capture.configure().empty());
  for (int tick = 0; tick < 3; ++tick) {
    capture.clock().advance_to(tick * 100'000'000);
    capture.run();
  }
  CHECK(capture.captured() == 3);
  CHECK(capture.dropped() == std::map<std::string, uint64_t>{{"downstream_full", 2}});
  REQUIRE(drop_set(capture));
  capture.clock().advance_to(300'000'000);
  capture.run();
  const auto front = capture.pop("front");
  REQUIRE(front);
  CHECK(front->sequence() == 3);
  CHECK(pixel(*front, 0, 0)[1] == 3);
}

TEST_CASE("in real time a capture that is called late delivers the newest set and counts the late ones") {
  TemporaryFolder folder;
  const char* names[] = {"front", "right", "rear", "left"};
  for (int c = 0; c < 4; ++c) write_video(folder.path() / (std::string(names[c]) + ".mkv"), c, 6);
  CaptureAlone capture(folder.path().string());
  capture.pace.real_time = capture.pace.virtual_clock = true;
  capture.pace.fps = 10;
  REQUIRE(capture.configure().empty());
  capture.run();
  capture.clock().advance_to(410'000'000);
  capture.run();
  CHECK(capture.captured() == 5);
  CHECK(capture.dropped() == std::map<std::string, uint64_t>{{"late", 3}});
  CHECK(capture.pop("front")->sequence() == 0);
  const auto newest = capture.pop("front");
  REQUIRE(newest);
  CHECK(newest->sequence() == 4);
  CHECK(newest->timestamp_ns() == 400'000'000);
  CHECK(newest->captured_ns() == 410'000'000);
  CHECK(pixel(*newest, 0, 0)[1] == 4);
}

TEST_CASE("cameras that nobody listens to are not read") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 2);
  CaptureAlone capture(folder.path().string());
  capture.disconnect("left");
  REQUIRE(capture.configure().empty());
  std::filesystem::remove(folder.path() / "left" / "000001.png");
  capture.run();
  CHECK(capture.failure() == "");
  CHECK(capture.captured() == 2);
}

TEST_CASE("a scene that comes with the program gives pictures of its rig's size at its cameras' times") {
  CaptureAlone capture("simulated:toy");
  capture.pace.frames = 2;
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  CHECK(capture.failure() == "");
  for (uint64_t n = 0; n < 2; ++n) {
    const auto left = capture.pop("left");
    REQUIRE(left);
    CHECK(left->sequence() == n);
    CHECK(std::abs(left->timestamp_ns() - static_cast<int64_t>(n) * 33'333'333) < 16'000'000);
    const Format& format = left->format();
    CHECK(pixel(*left, format.width_px / 2, format.height_px * 2 / 3) != cv::Vec3b(0, 0, 0));
  }
  CHECK(capture.pop_end("left"));
}

TEST_CASE("real stills are captured with the size that their readme names") {
  const auto data = data_folder();
  if (!data) {
    WARN("skipped: no test data");
    return;
  }
  CaptureAlone capture((*data / "real_car_carpet" / "images").string());
  capture.pace.frames = 1;
  REQUIRE(text_of(capture.configure()) == "");
  CHECK(capture.output_format("rear").front() == Format::bgr8(960, 640));
  capture.run();
  CHECK(drop_set(capture));
}
