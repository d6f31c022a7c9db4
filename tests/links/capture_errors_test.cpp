#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "tests/catch.h"
#include "tests/links/capture_harness.h"
#include "tests/links/pictures.h"
#include "tests/test_data.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

std::string faults_of(const std::string& source, const std::string& rig = "") {
  CaptureAlone capture(source, rig);
  return text_of(capture.configure());
}

std::string faults_of(const TemporaryFolder& folder) {
  return faults_of(folder.path().string());
}

}  // namespace

TEST_CASE("a directory that does not exist is named") {
  CHECK_THAT(faults_of("/nowhere/at/all"), Contains("/nowhere/at/all") && Contains("no such directory"));
}

TEST_CASE("all cameras that are missing are named at once") {
  TemporaryFolder folder;
  write_picture(folder.path() / "front.png", numbered_picture(0, 0));
  write_picture(folder.path() / "left.png", numbered_picture(3, 0));
  CHECK_THAT(faults_of(folder),
             Contains("camera \"right\"") && Contains("camera \"rear\"") && !Contains("\"left\""));
}

TEST_CASE("a file of an odd type is named") {
  TemporaryFolder folder;
  write_stills(folder.path());
  fs::rename(folder.path() / "rear.png", folder.path() / "rear.gif");
  CHECK_THAT(faults_of(folder), Contains("rear.gif") && Contains(".png"));
}

TEST_CASE("two files for one camera are not chosen from") {
  TemporaryFolder folder;
  write_stills(folder.path());
  fs::copy(folder.path() / "rear.png", folder.path() / "back.png");
  CHECK_THAT(faults_of(folder), Contains("back.png") && Contains("rear.png"));
}

TEST_CASE("stills and videos cannot be mixed") {
  TemporaryFolder folder;
  write_stills(folder.path());
  fs::remove(folder.path() / "right.png");
  write_video(folder.path() / "right.mkv", 1, 2);
  CHECK_THAT(faults_of(folder), Contains("right is a video"));
}

TEST_CASE("a picture that is cut off is found in every format, wherever it is cut") {
  const std::string extension = GENERATE("png", "jpg", "bmp");
  const double share = GENERATE(0.2, 0.5, 0.95);
  TemporaryFolder folder;
  write_stills(folder.path());
  fs::remove(folder.path() / "left.png");
  const fs::path left = folder.path() / ("left." + extension);
  cv::Mat noise(48, 64, CV_8UC3);
  cv::randu(noise, 0, 255);
  write_picture(left, noise);
  REQUIRE(faults_of(folder).empty());
  cut_off(left, share);
  CHECK_THAT(faults_of(folder), Contains(left.string()) && Contains("cut off"));
}

TEST_CASE("a JPEG with bytes behind its end is whole") {
  TemporaryFolder folder;
  write_stills(folder.path());
  fs::remove(folder.path() / "left.png");
  write_picture(folder.path() / "left.jpg", numbered_picture(3, 0));
  std::ofstream(folder.path() / "left.jpg", std::ios::app | std::ios::binary) << "maker's data";
  CHECK(faults_of(folder).empty());
}

TEST_CASE("a file that is empty, of another kind or damaged inside is found") {
  TemporaryFolder folder;
  write_stills(folder.path());
  std::ofstream(folder.path() / "front.png", std::ios::trunc);
  std::ofstream(folder.path() / "right.png", std::ios::trunc) << "not a picture at all";
  std::fstream(folder.path() / "rear.png", std::ios::in | std::ios::out | std::ios::binary).seekp(40)
      << "scribbled over";
  CHECK_THAT(faults_of(folder), Contains("front.png: error: is empty") &&
                                    Contains("right.png: error: holds no PNG") &&
                                    Contains("rear.png: error: is damaged"));
}

TEST_CASE("cameras with different numbers of frames are named with their counts") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 3);
  fs::remove(folder.path() / "rear" / "000001.png");
  CHECK_THAT(faults_of(folder), Contains("rear has 2 frames, front has 3"));
}

TEST_CASE("a camera's folder without frames is named") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 1);
  fs::remove(folder.path() / "right" / "000000.png");
  CHECK_THAT(faults_of(folder), Contains((folder.path() / "right").string()) && Contains("no frames"));
}

TEST_CASE("a numbered frame that is cut off is found before the first frame") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 3);
  cut_off(folder.path() / "left" / "000002.png");
  CHECK_THAT(faults_of(folder), Contains("000002.png") && Contains("cut off"));
}

TEST_CASE("a numbered frame of another size stops the run with camera, frame and file") {
  TemporaryFolder folder;
  write_numbered(folder.path(), 3);
  write_picture(folder.path() / "rear" / "000001.png", numbered_picture(2, 1, {10, 6}));
  CaptureAlone capture(folder.path().string());
  REQUIRE(text_of(capture.configure()) == "");
  capture.run();
  CHECK_THAT(capture.failure(), Contains("rear frame 1") && Contains("000001.png") && Contains("10x6"));
  CHECK(capture.pop("front")->sequence() == 0);
  CHECK(!capture.pop("front"));
}

TEST_CASE("a video that cannot be opened is named") {
  TemporaryFolder folder;
  for (const char* camera : {"front", "right", "rear"})
    write_video(folder.path() / (std::string(camera) + ".mkv"), 0, 2);
  std::ofstream(folder.path() / "left.mp4") << "no video";
  CHECK_THAT(faults_of(folder), Contains("left.mp4") && Contains("cannot be opened"));
}

TEST_CASE("a video that ends before its container's count stops the run") {
  TemporaryFolder folder;
  for (const char* camera : {"front", "right", "rear", "left"}) {
    write_video(folder.path() / (std::string(camera) + ".mkv"), 0, 40, {64, 48});
  }
  cut_off(folder.path() / "rear.mkv", 0.6);
  CaptureAlone capture(folder.path().string());
  const std::string faults = text_of(capture.configure());
  capture.run();
  // Containers that keep their count at the end lose it with the cut: then the difference is found
  // beforehand.
  CHECK_THAT(faults + capture.failure(), Contains("rear") && Contains("frames"));
}

TEST_CASE("pictures have to have the size that the rig says") {
  TemporaryFolder folder;
  write_stills(folder.path());
  const fs::path rig = folder.path() / "rig.json";
  const std::string camera = R"({"image_size_px":[1280,720],
    "lens":{"model":"kannala_brandt","focal_px":[330,330],"centre_px":[639.5,359.5],"k":[0,0,0,0]},
    "vehicle_from_camera":{"translation_m":[2.4,0,0.7],"quaternion_xyzw":[-0.5,0.5,-0.5,0.5]}})";
  std::ofstream(rig) << R"({"vehicle":{"length_m":4.8,"width_m":1.9},"cameras":{"front":)" << camera
                     << R"(,"right":)" << camera << R"(,"rear":)" << camera << R"(,"left":)" << camera
                     << "}}";
  CHECK_THAT(faults_of(folder.path().string(), rig.string()),
             Contains("\"front\" are 8x6 px") && Contains("\"left\" are 8x6 px") && Contains("1280x720"));
}

TEST_CASE("an unknown scene is named with those there are") {
  CHECK_THAT(faults_of("simulated:parkin"), Contains("simulated:parkin") && Contains("no such scene"));
}

TEST_CASE("a camera left out, misspelt or given twice in a list of URLs is named") {
  CHECK_THAT(faults_of("front=a,rigth=b,front=c"), Contains("camera \"rigth\", did you mean \"right\"?") &&
                                                       Contains("camera \"front\" is given twice") &&
                                                       Contains("nothing for camera \"rear\""));
}

TEST_CASE("URLs that cannot be opened are all named") {
  CHECK_THAT(faults_of("front=/none/a.mp4,right=/none/b.mp4,back=/none/c.mp4,left=/none/d.mp4"),
             Contains("front=/none/a.mp4") && Contains("rear=/none/c.mp4") && Contains("left=/none/d.mp4"));
}
