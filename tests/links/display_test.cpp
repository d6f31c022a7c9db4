#include "links/display/display.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <openssl/evp.h>

#include "framework/testing/harness.h"
#include "tests/catch.h"
#include "tests/links/pictures.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

const cv::Size kSize(30, 20);

struct DisplayAlone : LinkHarness {
  explicit DisplayAlone(const fs::path& path, cv::Size size = kSize) : LinkHarness(make_display()) {
    setting("output", path.string());
    input("frames", {Format::bgr8(size.width, size.height)});
  }
};

void push(LinkHarness& display, int n, cv::Size size = kSize) {
  display.push("frames",
               {.sequence = static_cast<uint64_t>(n), .write = [&](int, std::span<std::byte> bytes) {
                  const auto pitch = static_cast<size_t>(Format::bgr8(size.width, size.height).pitch_bytes);
                  cv::Mat target(size, CV_8UC3, bytes.data(), pitch);
                  numbered_picture(9, n, size).copyTo(target);
                }});
  display.run();
}

void deliver(LinkHarness& display, int frames) {
  REQUIRE(text_of(display.configure()) == "");
  for (int n = 0; n < frames; ++n) push(display, n);
  display.stop();
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

size_t entries(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string faults_of(const fs::path& output, cv::Size size = kSize) {
  DisplayAlone display(output, size);
  return text_of(display.configure());
}

}  // namespace

TEST_CASE("a .png is the last frame, and nothing else is left in the folder") {
  TemporaryFolder folder;
  DisplayAlone display(folder.path() / "out.png");
  deliver(display, 3);
  CHECK(same(cv::imread((folder.path() / "out.png").string()), numbered_picture(9, 2, kSize)));
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a directory gets every frame as a numbered picture") {
  TemporaryFolder folder;
  const fs::path output = folder.path() / (GENERATE(true, false) ? "frames" : "frames/");
  DisplayAlone display(output);
  deliver(display, 3);
  CHECK(entries(output) == 3);
  CHECK(same(cv::imread((folder.path() / "frames" / "000001.png").string()), numbered_picture(9, 1, kSize)));
}

TEST_CASE("an .mkv has every pixel of every frame at the run's rate") {
  TemporaryFolder folder;
  DisplayAlone display(folder.path() / "out.mkv");
  display.pace.fps = 12;
  deliver(display, 4);
  cv::VideoCapture video((folder.path() / "out.mkv").string());
  CHECK(video.get(cv::CAP_PROP_FPS) == Approx(12));
  cv::Mat frame;
  for (int n = 0; n < 4; ++n) {
    REQUIRE(video.read(frame));
    CHECK(same(frame, numbered_picture(9, n, kSize)));
  }
  CHECK(!video.read(frame));
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("an .mp4 has every frame") {
  TemporaryFolder folder;
  DisplayAlone display(folder.path() / "out.mp4");
  deliver(display, 4);
  cv::VideoCapture video((folder.path() / "out.mp4").string());
  int frames = 0;
  for (cv::Mat frame; video.read(frame); ++frames) CHECK(frame.size() == kSize);
  CHECK(frames == 4);
}

TEST_CASE("without a frame nothing is written, and what was there stays") {
  TemporaryFolder folder;
  const std::string name = GENERATE("out.png", "out.mp4", "out.mkv", "frames");
  DisplayAlone display(folder.path() / name);
  deliver(display, 0);
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE("a file has its name only once it is complete") {
  TemporaryFolder folder;
  const std::string name = GENERATE("out.png", "out.mp4", "out.mkv");
  DisplayAlone display(folder.path() / name);
  REQUIRE(display.configure().empty());
  push(display, 0);
  CHECK(!fs::exists(folder.path() / name));
  display.stop();
  CHECK(fs::exists(folder.path() / name));
}

TEST_CASE("an output whose folder goes away during the run is named, and nothing is left") {
  TemporaryFolder folder;
  const std::string name = GENERATE("out.png", "out.mp4", "out.mkv");
  fs::create_directory(folder.path() / "gone");
  DisplayAlone display(folder.path() / "gone" / name);
  REQUIRE(display.configure().empty());
  push(display, 0);
  fs::remove_all(folder.path() / "gone");
  CHECK_THROWS_WITH(display.stop(), Contains(name));
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE("what cannot be written is found before the first frame") {
  TemporaryFolder folder;
  CHECK_THAT(faults_of(folder.path() / "none" / "out.png"), Contains("does not exist"));
  CHECK_THAT(faults_of(folder.path() / "out.jpg"), Contains("\".jpg\"") && Contains(".png, .mp4, .mkv"));
  CHECK_THAT(faults_of(""), Contains("is empty"));
  fs::create_directory(folder.path() / "folder.png");
  CHECK_THAT(faults_of(folder.path() / "folder.png"), Contains("is a folder"));
  std::ofstream(folder.path() / "file") << "text";
  CHECK_THAT(faults_of(folder.path() / "file"), Contains("is a file"));
  CHECK_THAT(faults_of(folder.path() / "out.mp4", {31, 20}), Contains("31x20") && Contains("even"));
}

TEST_CASE("faults of the path are found even where it is not known what comes in") {
  LinkHarness display(make_display());
  display.setting("output", "out.gif");
  CHECK_THAT(text_of(display.configure()), Contains("\".gif\""));
}

TEST_CASE("a window without a display is a fault") {
  if (std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY")) {
    WARN("skipped: there is a display");
    return;
  }
  CHECK_THAT(faults_of("window"), Contains("DISPLAY"));
}

TEST_CASE("the hash is over all delivered pixels in order, without padding") {
  DisplayAlone display("none");
  display.parameter("sha256", true);
  deliver(display, 2);
  std::string pixels;
  for (int n = 0; n < 2; ++n) {
    const cv::Mat picture = numbered_picture(9, n, kSize);
    pixels.append(reinterpret_cast<const char*>(picture.data), picture.total() * 3);
  }
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  REQUIRE(EVP_Digest(pixels.data(), pixels.size(), digest, &length, EVP_sha256(), nullptr) == 1);
  std::string expected;
  for (unsigned int i = 0; i < length; ++i) {
    char two[3];
    std::snprintf(two, sizeof(two), "%02x", digest[i]);
    expected += two;
  }
  CHECK(display.report()["output"]["sha256"] == expected);
}

TEST_CASE("without being asked for there is no hash") {
  DisplayAlone display("none");
  deliver(display, 1);
  CHECK(!display.report().contains("output"));
}
