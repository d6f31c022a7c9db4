// Frames that cannot be used are found before the first one is shown, all of them at once.

#include <opencv2/imgcodecs.hpp>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

/// Four stills and a rig that fit, to be spoiled.
struct Setting {
  TemporaryFolder folder;
  fs::path rig = folder.path() / "rig.json";
  fs::path input = folder.path() / "input";
  fs::path output = folder.path() / "output";

  Setting() {
    write_json(rig, small_rig());
    write_stills(input);
    fs::create_directory(output);
  }
  Outcome refused() const {
    const Outcome outcome = svchain_program(
        small_run("2dsv_2dsp", rig, input,
                  {"--output", output / "view.png", "--report", output / "report.json", "--frames", "3"}));
    CHECK(outcome.status == 2);
    CHECK(count_of(output) == 0);
    return outcome;
  }
};

}  // namespace

TEST_CASE("a missing image is named") {
  const Setting setting;
  fs::remove(setting.input / "rear.png");
  CHECK_THAT(setting.refused().err, Contains("rear"));
}

TEST_CASE("a truncated and a corrupt image are both named") {
  const Setting setting;
  const std::string png = read_text(setting.input / "front.png");
  write_text(setting.input / "front.png", png.substr(0, png.size() / 2));
  write_text(setting.input / "left.png", "this is no picture");
  const auto said = setting.refused().err;
  CHECK_THAT(said, Contains("front.png") && Contains("left.png"));
}

TEST_CASE("an image of another size than the rig's is named with both sizes") {
  const Setting setting;
  cv::imwrite(setting.input / "right.png", cv::Mat(100, 200, CV_8UC3, cv::Scalar(1, 2, 3)));
  CHECK_THAT(setting.refused().err, Contains("right") && Contains("200x100") && Contains("320x180"));
}

TEST_CASE("a video that cannot be opened is named") {
  const Setting setting;
  for (const auto& camera : kCameras) {
    fs::remove(setting.input / (camera + ".png"));
    write_text(setting.input / (camera + ".mp4"), "this is no video");
  }
  CHECK_THAT(setting.refused().err, Contains("front.mp4"));
}

TEST_CASE("an input folder that is not there is named") {
  Setting setting;
  setting.input = setting.folder.path() / "nowhere";
  CHECK_THAT(setting.refused().err, Contains("nowhere"));
}

TEST_CASE("a bad input, a bad output and a bad report are all told at once") {
  const auto outcome = svchain_program({"--usecase", "2dsv_2dsp", "--input", "/nowhere/in", "--output",
                                        "/nowhere/out.png", "--report", "/nowhere/report.json"});
  CHECK(outcome.status == 2);
  for (const char* part : {"/nowhere/in", "/nowhere/out.png", "--report: error:", "--rig: error: missing"}) {
    CHECK_THAT(outcome.err, Contains(part));
  }
}

TEST_CASE("frames from outside need a rig") {
  const Setting setting;
  const auto outcome = svchain_program({"--usecase", "2dsv_2dsp", "--input", setting.input});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--rig: error: missing"));
}

TEST_CASE("an unknown scene is answered with those there are") {
  const auto outcome = svchain_program({"--usecase", "2dsv_2dsp", "--input", "simulated:parkin"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("parkin") && Contains("parking"));
}

TEST_CASE("an output that cannot be written is refused before the run, like a report") {
  const Setting setting;
  const auto outcome =
      svchain_program(small_run("2dsv_2dsp", setting.rig, setting.input,
                                {"--output", setting.folder.path() / "nowhere" / "view.png", "--report",
                                 setting.folder.path() / "nowhere" / "report.json"}));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("view.png") && Contains("--report: error:") && Contains("report.json"));
}

TEST_CASE("an output of an unknown kind is answered with the known kinds") {
  const Setting setting;
  const auto outcome = svchain_program(
      small_run("2dsv_2dsp", setting.rig, setting.input, {"--output", setting.output / "view.gif"}));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains(".gif") && Contains(".png"));
}

TEST_CASE("a frame that spoils during the run fails it: status 1, and what and where on stderr") {
  const Setting setting;
  fs::remove_all(setting.input);
  write_numbered(setting.input, 4);
  cv::imwrite(setting.input / "left" / "000002.png", cv::Mat(90, 160, CV_8UC3, cv::Scalar(1, 2, 3)));
  const auto outcome = svchain_program(small_run("2dsv_2dsp", setting.rig, setting.input, {}));
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("svchain: error: IPU1/capture: ") && Contains("left frame 2: "));
}
