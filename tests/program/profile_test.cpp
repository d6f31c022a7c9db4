// svchain profile: what links cost here, for --costs and SoC files.

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

/// Of four small still pictures and a view that is quickly made.
Arguments profile_of(const std::filesystem::path& folder, const Arguments& more) {
  write_json(folder / "rig.json", small_rig());
  write_stills(folder / "images");
  Arguments all = {"profile", "2dsv_2dsp",       "--rig", folder / "rig.json",
                   "--input", folder / "images", "--set", "view.size_px=[320,400]"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST_CASE("profile writes what links cost relative to synthesis, and a modelled run rests on it") {
  const TemporaryFolder folder;
  const auto costs = folder.path() / "costs.json";
  const auto outcome = svchain_program(profile_of(folder.path(), {"--frames", "4", "--output", costs}));
  INFO(outcome.err + outcome.out);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("100.00 %") && Contains("the anchor") && Contains("left out: a source") &&
                              Contains("left out: too short to measure"));
  const std::string text = read_text(costs);
  if (has_schema_validator()) CHECK(fits_schema("costs", text));
  CHECK_THAT(svchain_program({"validate", costs}).out, Contains("ok (costs)"));

  const Json cycles = Json::parse(text)["costs"]["cycles"]["C66x"];
  CHECK(cycles["synthesis"]["per_output_px"] == 15.7828);
  CHECK(cycles["synthesis"]["bytes_per_output_px"] == 20);
  const Json& geometric = cycles["geometric_alignment"];
  CHECK(geometric.value("per_result", 0.0) + geometric.value("per_output_px", 0.0) > 0);
  CHECK(geometric.value("per_input_px", 0.0) == 0);
  CHECK_THAT(geometric["source"].get<std::string>(),
             Contains("measured on ") && Contains("relative to synthesis"));

  const auto run = svchain_program({"--usecase", "2dsv_2dsp", "--clock", "virtual", "--no-pixels", "--fps",
                                    "30", "--frames", "60", "--costs", costs, "--report", "-"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  const Json links = Json::parse(run.out)["modelled"]["links"];
  CHECK(links["geometric_alignment"]["basis"] == geometric["source"]);
  CHECK(links["synthesis"]["basis"].get<std::string>().starts_with("the paper"));
  CHECK(links["dup"]["basis"] == "assumed");
  CHECK(svchain_program({"explore", "2dsv_2dsp", "--soc", "tda3x", "--costs", costs}).status == 0);
}

TEST_CASE("profile refuses anchors that the use case or the SoC does not know, and live input") {
  const TemporaryFolder folder;
  const Arguments output = {"--output", folder.path() / "costs.json"};
  const auto refused = [&](Arguments more) {
    more.insert(more.end(), output.begin(), output.end());
    const auto outcome = svchain_program(profile_of(folder.path(), more));
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK_THAT(
      refused({"--anchor", "synthesys"}),
      Contains("--anchor: error: there is no link \"synthesys\"") && Contains("did you mean \"synthesis\"?"));
  CHECK_THAT(refused({"--frames", "one"}), Contains("--frames: error:"));
  Json bare = Json::parse(read_text(project_folder() / "configs" / "socs" / "tda2x.json"));
  bare.erase("costs");
  write_json(folder.path() / "bare.json", bare);
  CHECK_THAT(refused({"--soc", folder.path() / "bare.json"}),
             Contains("--anchor: error: tda2x has no figure for synthesis on C66x"));
  const auto live =
      svchain_program({"profile", "2dsv_2dsp", "--rig", folder.path() / "rig.json", "--input",
                       "front=/dev/a,right=/dev/b,rear=/dev/c,left=/dev/d", "--output", output[1]});
  CHECK(live.status == 2);
  CHECK_THAT(live.err, Contains("--input: error: is live"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "costs.json"));
}

TEST_CASE("costs that are bad, or for a run that has none, are told as faults") {
  const TemporaryFolder folder;
  const auto costs = folder.path() / "costs.json";
  write_text(costs, R"({"costs":{"cycles":{"C66x":{"synthesis":{"per_pixel":3}}}}})");
  const auto steady = svchain_program({"--usecase", "2dsv_2dsp", "--costs", costs});
  CHECK(steady.status == 2);
  CHECK_THAT(steady.err, Contains("--costs: error: expected --clock virtual") && Contains("costs.json:1:") &&
                             Contains("/costs/cycles/C66x/synthesis/per_pixel"));
  CHECK(svchain_program({"validate", costs}).status == 2);
  CHECK(svchain_program({"explore", "2dsv_2dsp", "--costs", costs}).status == 2);
}
