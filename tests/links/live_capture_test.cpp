#include "links/capture/frame_source.h"
#include "tests/catch.h"
#include "tests/links/capture_harness.h"
#include "tests/links/pictures.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

/// Streams that are read as fast as they come.
std::string streams(const TemporaryFolder& folder, int frames) {
  std::string source;
  for (const char* camera : {"front", "right", "rear", "left"}) {
    const auto file = folder.path() / (std::string(camera) + ".mkv");
    write_video(file, 0, frames);
    source += (source.empty() ? "" : ",") + std::string(camera) + "=" + file.string();
  }
  return source;
}

}  // namespace

TEST_CASE("a list of URLs is a live source, a folder is none") {
  CHECK(is_live_source("front=rtsp://a,right=0,rear=1,left=2"));
  CHECK(is_live_source("back=0,front=1"));
  CHECK(!is_live_source("/some/folder"));
  CHECK(!is_live_source("simulated:parking"));
}

TEST_CASE("a live source gives the newest frame of each camera and ends with the last of them") {
  TemporaryFolder folder;
  CaptureAlone capture(streams(folder, 4));
  capture.pace.fps = 1e6;
  REQUIRE(text_of(capture.configure()) == "");
  Frame newest;
  for (int64_t now = 0; !capture.pop_end("rear"); now += 1000) {  // the streams end by themselves
    capture.clock().advance_to(now);
    capture.run(1);
    if (auto frame = capture.pop("rear")) newest = std::move(*frame);
    for (const char* camera : {"front", "right", "left"}) capture.pop(camera);
  }
  CHECK(capture.failure() == "");
  REQUIRE(newest);
  CHECK(pixel(newest, 0, 0)[1] == 3);
  CHECK(capture.captured() >= 1);
}

TEST_CASE("a live source can be stopped while its cameras go on") {
  TemporaryFolder folder;
  CaptureAlone capture(streams(folder, 200));
  REQUIRE(text_of(capture.configure()) == "");
  capture.run(1);
  while (drop_set(capture)) continue;
  capture.stop();
  CHECK(capture.buffers_in_use() == 0);
}

TEST_CASE("the rate of videos is their container's") {
  TemporaryFolder folder;
  streams(folder, 2);
  CHECK(source_fps(folder.path().string()) == Approx(25));
  CHECK(!source_fps("/nowhere"));
}
