// Modelled time as a user has it: --clock virtual, --no-pixels, svchain explore.

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
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1 + 8 + 1 + 8);  // tda2x, tda2eco, tda3x
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
