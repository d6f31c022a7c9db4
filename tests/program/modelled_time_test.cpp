// Modelled time as a user has it: --clock virtual, --no-pixels, svchain explore.

#include <regex>

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

/// The simulated world at 30 fps for 10 s, in full size.
Arguments without_pixels(const Arguments& more, const std::string& use_case = "2dsv_2dsp") {
  Arguments all = {"--usecase", use_case, "--clock",  "virtual", "--no-pixels", "--fps", "30",
                   "--frames",  "300",    "--report", "-"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST_CASE("a run without pixels reports modelled loads and says what they rest on") {
  const auto outcome = svchain_program(without_pixels({}));
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json report = Json::parse(outcome.out);
  CHECK(report["clock"] == "virtual");
  CHECK(report["after_power_up"]["cores"]["DSP2"]["load"].get<double>() == Approx(0.75).margin(0.01));
  CHECK(report["modelled"]["links"]["synthesis"]["basis"].get<std::string>().starts_with("the paper"));
  CHECK(report["modelled"]["links"]["capture"]["basis"] == "assumed");
  CHECK(report["modelled"]["links"]["capture"]["clock_basis"] == "clock assumed");
  CHECK(report["modelled"]["links"]["synthesis"]["clock_basis"].get<std::string>().starts_with("the paper"));
  CHECK_FALSE(report.contains("output"));
  if (has_schema_validator()) CHECK(fits_schema("report", outcome.out));
}

TEST_CASE("modelled runs print the same report to the byte, and another SoC has another load") {
  const auto text = [](const Arguments& more) { return svchain_program(without_pixels(more)).out; };
  CHECK(text({}) == text({}));
  CHECK(text({"--seed", "5"}) == text({"--seed", "5"}));
  const auto eco_run = svchain_program(without_pixels({"--soc", "tda2eco"}, "2dsv_1dsp"));
  INFO(eco_run.err);
  REQUIRE(eco_run.status == 0);
  const Json eco = Json::parse(eco_run.out);
  CHECK(eco["after_power_up"]["cores"]["DSP1"]["load"].get<double>() == Approx(0.78).margin(0.01));
}

TEST_CASE("no pixels without the virtual clock, or with somewhere to write them, is bad usage") {
  const auto steady = svchain_program({"--usecase", "2dsv_2dsp", "--no-pixels"});
  CHECK(steady.status == 2);
  CHECK_THAT(steady.err, Contains("--no-pixels: error: expected --clock virtual"));
  const TemporaryFolder folder;
  const auto written = svchain_program(without_pixels({"--output", folder.path() / "view.png"}));
  CHECK(written.status == 2);
  CHECK_THAT(written.err, Contains("--no-pixels: error:") && Contains("expected --output none"));
  CHECK(count_of(folder.path()) == 0);
}

TEST_CASE("a SoC without clocks runs, but not in modelled time") {
  const TemporaryFolder folder;
  const auto soc = folder.path() / "plain.json";
  write_text(soc,
             R"({"name":"plain","roles":{"host":"A15"},"cores":{"A15":{"kind":"A15"},"IPU1":{"kind":"M4"},
    "DSP1":{"kind":"C66x","clock_mhz":600}}})");
  const auto outcome =
      svchain_program({"--usecase", "2dsv_1dsp", "--soc", soc, "--clock", "virtual", "--no-pixels"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("/cores/A15") && Contains("/cores/IPU1") && !Contains("/cores/DSP1") &&
                              Contains("\"clock_mhz\" is missing"));
}

TEST_CASE("explore tells which placements hold the rate, best first, and writes the best as a use case") {
  const TemporaryFolder folder;
  const auto best = folder.path() / "best.json";
  const auto outcome = svchain_program({"explore", "2dsv_2dsp", "--output", best});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const std::string table = outcome.out.substr(0, outcome.out.find("\n\n"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 8 + 1 + 8);  // tda2x, tda2eco, tda3x
  const std::string first = outcome.out.substr(outcome.out.find('\n') + 1);
  CHECK(first.find(" yes ") < first.find('\n'));
  CHECK_THAT(outcome.out, Contains("tda2eco") && Contains("synthesis DSP2") && !Contains(" no "));
  const auto run = svchain_program({"--usecase", best, "--clock", "virtual", "--no-pixels", "--fps", "30",
                                    "--frames", "300", "--report", "-"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  CHECK(Json::parse(run.out)["after_power_up"]["dropped"] == 0);
}

TEST_CASE(
    "explore says of an output too large for one DSP that no placement holds it, and which core is full") {
  const auto outcome = svchain_program({"explore", "2dsv_2dsp", "--set", "view.size_px=[1280,1440]"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains(" no ") && !Contains(" yes ") && Contains("100 %"));
}

TEST_CASE("the largest view that explore says a TDA2x holds is held, 2 px more are not, and DSP2 is why") {
  const auto outcome = svchain_program({"explore", "2dsv_2dsp", "--soc", "tda2x"});
  INFO(outcome.err + outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("largest view that holds 30 frames/s") && !Contains("tda3x"));
  std::smatch said;
  REQUIRE(std::regex_search(
      outcome.out, said,
      std::regex(R"(tda2x +(\d+) x (\d+) px; at (\d+) x (\d+) px (\w+) is full +\(.*synthesis (\w+))")));
  CHECK(said[5] == "DSP2");
  CHECK(said[6] == "DSP2");
  // 600 MHz / 30 / 15.7828 cycles = 1 267 201 px
  CHECK(said[1] == "1016");
  CHECK(said[2] == "1246");
  CHECK(said[3] == "1018");
  const auto after = [&](const std::string& width, const std::string& height) {  // the minute tells 0.4 %
    const auto run = svchain_program({"--usecase", "2dsv_2dsp", "--clock", "virtual", "--no-pixels", "--fps",
                                      "30", "--frames", "2100", "--set",
                                      "view.size_px=[" + width + "," + height + "]", "--report", "-"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return Json::parse(run.out)["after_power_up"];
  };
  const Json below = after(said[1], said[2]), above = after(said[3], said[4]);
  CHECK(below["dropped"] == 0);
  CHECK(below["fps"].get<double>() == Approx(30).epsilon(0.01));
  CHECK(above["dropped"] > 0);
  CHECK(above["cores"]["DSP2"]["load"].get<double>() > 0.99);
  CHECK(above["cores"]["DSP1"]["load"].get<double>() < 0.1);
}

TEST_CASE("explore takes a SoC of one's own, and says which of its cores have no clock") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "fast.json", best = folder.path() / "best.json";
  Json soc = Json::parse(read_text(project_folder() / "configs" / "socs" / "tda2x.json"));
  soc["name"] = "fast";
  for (const char* dsp : {"DSP1", "DSP2"}) soc["cores"][dsp]["clock_mhz"] = 1200;
  write_json(file, soc);
  const auto outcome = svchain_program({"explore", "2dsv_2dsp", "--soc", file, "--output", best});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("\nfast") && Contains("synthesis DSP2") && !Contains("tda3x"));
  CHECK(Json::parse(read_text(best))["soc"] == file.string());
  soc["cores"]["DSP2"].erase("clock_mhz");
  write_json(file, soc);
  const auto refused = svchain_program({"explore", "2dsv_2dsp", "--soc", file});
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("/cores/DSP2") && Contains("\"clock_mhz\" is missing"));
}

TEST_CASE("explore leaves what is drawn by graphics there, and SoCs without graphics out") {
  const auto outcome = svchain_program({"explore", "3dsv"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("bowl_view SGX") && Contains("tda2eco") && !Contains("bowl_view DSP") &&
                              !Contains("tda3x"));
}

TEST_CASE("explore tells bad rates and unknown use cases at once") {
  const auto outcome = svchain_program({"explore", "2dsv_3dsp", "--fps", "fast"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--fps: error:") && Contains("2dsv_3dsp"));
}
