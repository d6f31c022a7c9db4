// What is wrong with a use case is said before anything runs: where it stands, what it is, and the nearest
// right name.

#include <functional>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

/// Runs a changed 2dsv_2dsp with an output and a report; whatever is wrong with it, nothing may have been
/// written.
Outcome refused(const std::function<void(Json&)>& change, const Arguments& more = {}) {
  const TemporaryFolder folder;
  Json use_case = shipped_use_case("2dsv_2dsp");
  change(use_case);
  write_json(folder.path() / "changed.json", use_case);
  Arguments arguments = {"--usecase", folder.path() / "changed.json", "--output", folder.path() / "view.png",
                         "--report",  folder.path() / "report.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = svchain_program(arguments);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(count_of(folder.path()) == 1);
  return outcome;
}

Outcome refused_text(const std::string& text) {
  const TemporaryFolder folder;
  write_text(folder.path() / "text.json", text);
  const Outcome outcome = svchain_program({"--usecase", folder.path() / "text.json"});
  CHECK(outcome.status == 2);
  return outcome;
}

}  // namespace

TEST_CASE("an unknown key is named with line, column and the key that was probably meant") {
  const auto said = refused([](Json& u) { u["link"] = u["links"]; }).err;
  CHECK_THAT(said, Catch::Matches("(.|\n)*changed\\.json:[0-9]+:[0-9]+: error: (.|\n)*"));
  CHECK_THAT(said, Contains("/link: unknown key") && Contains("did you mean \"links\"?"));
}

TEST_CASE("an unknown link type is named with the type that was probably meant") {
  const auto said = refused([](Json& u) { u["links"]["synthesis"]["type"] = "syntesis"; }).err;
  CHECK_THAT(said, Contains("/links/synthesis") && Contains("\"syntesis\"") &&
                       Contains("did you mean \"synthesis\"?"));
}

TEST_CASE("an unknown port is named with those there are") {
  const auto said = refused([](Json& u) { u["edges"][4] = "sync.frame -> dup.in"; }).err;
  CHECK_THAT(said,
             Contains("/edges/4") && Contains("\"sync.frame\"") && Contains("did you mean \"frames\"?"));
}

TEST_CASE("a core that the SoC lacks is named with those it has") {
  const auto said = refused([](Json& u) { u["links"]["synthesis"]["core"] = "DSP3"; }).err;
  CHECK_THAT(said, Contains("/links/synthesis/core") && Contains("\"DSP3\"") && Contains("DSP1, DSP2"));
}

TEST_CASE("a use case does not run on a SoC without its cores") {
  const auto said = refused([](Json&) {}, {"--soc", "tda2eco"}).err;
  CHECK_THAT(said, Contains("\"tda2eco\" has no core \"DSP2\""));
}

TEST_CASE("an unknown parameter is named with the one that was probably meant") {
  const auto said = refused([](Json& u) { u["links"]["sync"]["params"] = {{"delta", 10}}; }).err;
  CHECK_THAT(said, Contains("/links/sync/params/delta") && Contains("did you mean \"delta_ms\"?"));
}

TEST_CASE("a parameter out of range is answered with the range and its unit") {
  const auto said = refused([](Json& u) { u["links"]["sync"]["params"] = {{"delta_ms", -1}}; }).err;
  CHECK_THAT(said, Contains("/links/sync/params/delta_ms") && Contains("ms, got -1"));
}

TEST_CASE("an override by --set is checked like the file") {
  const auto said = refused([](Json&) {}, {"--set", "sync.delta_ms=-1", "--set", "synthesys.x=1"}).err;
  CHECK_THAT(said, Contains("--set sync.delta_ms=-1: error:"));
  CHECK_THAT(said, Contains("--set synthesys.x=1: error:") && Contains("did you mean \"synthesis\"?"));
}

TEST_CASE("two edges into one input are refused, naming both") {
  const auto said = refused([](Json& u) { u["edges"].push_back("dup.out2 -> synthesis.frames"); }).err;
  CHECK_THAT(
      said, Contains("\"synthesis.frames\" takes one edge only") && Contains("dup.out1 -> synthesis.frames"));
}

TEST_CASE("an input without an edge is refused by name") {
  const auto said = refused([](Json& u) { u["edges"].erase(7); }).err;
  CHECK_THAT(said, Contains("no edge leads to the input \"synthesis.lut\""));
}

TEST_CASE("a cycle without feedback is refused with its whole way") {
  const auto said = refused([](Json& u) { u["edges"][9].erase("feedback"); }).err;
  CHECK_THAT(said, Contains("cycle") && Contains("synthesis") && Contains("photometric_alignment"));
}

TEST_CASE("formats that do not fit name both ports and the field") {
  const auto said = refused([](Json& u) {
                      u["edges"][8] = "synthesis.view -> photometric_alignment.statistics";
                      u["edges"][10] = "synthesis.statistics -> display.frames";
                    }).err;
  CHECK_THAT(said, Contains("synthesis.statistics") && Contains("display.frames") && Contains("type"));
}

TEST_CASE("all faults of a use case and of the options come at once") {
  const auto said = refused(
                        [](Json& u) {
                          u["links"]["synthesis"]["type"] = "syntesis";
                          u["links"]["sync"]["params"] = {{"delta", 10}};
                        },
                        {"--frames", "none", "--rig", "nowhere.json", "--soc", "tda9"})
                        .err;
  for (const char* part : {"syntesis", "delta", "--frames: error:", "nowhere.json", "--soc: error:"}) {
    CHECK_THAT(said, Contains(part));
  }
}

TEST_CASE("a use case that is cut off is refused at its last line") {
  const std::string text = shipped_use_case("2dsv_2dsp").dump(1);
  const auto said = refused_text(text.substr(0, text.size() / 2)).err;
  CHECK_THAT(said, Catch::Matches("(.|\n)*text\\.json:[0-9]+:[0-9]+: error: (.|\n)*"));
}

TEST_CASE("a use case nested ten thousand deep is refused") {
  const auto said = refused_text(std::string(10000, '[') + std::string(10000, ']')).err;
  CHECK_THAT(said, Contains("text.json:1:") && Contains("error: "));
}

TEST_CASE("NaN is no number in a use case") {
  const auto said = refused_text(R"({"name": "x", "view": {"metres_per_px": NaN}, "links": {}})").err;
  CHECK_THAT(said, Contains("text.json:1:") && Contains("error: "));
}

TEST_CASE("an unknown use case is answered with those there are") {
  const auto outcome = svchain_program({"--usecase", "2dsv_2dps"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("--usecase: error: unknown use case \"2dsv_2dps\", did you mean \"2dsv_2dsp\"?"));
}

TEST_CASE("a plug-in that is not there is named") {
  const auto said = refused([](Json&) {}, {"--plugin", "nowhere.so"}).err;
  CHECK_THAT(said, Contains("nowhere.so"));
}

TEST_CASE("what is wrong with keys, types, cores and ports is shown all at once") {
  const TemporaryFolder folder;
  Json use_case = shipped_use_case("2dsv_2dsp");
  use_case["links"]["sync"]["core"] = "IPU9";
  use_case["links"]["dup"]["params"] = {{"outputs", 2}};
  use_case["edges"][0] = "capture.front -> sync.fornt";
  write_json(folder.path() / "bad.json", use_case);
  const auto outcome = svchain_program({"--usecase", folder.path() / "bad.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("unknown parameter \"outputs\""));
  CHECK_THAT(outcome.err, Contains("has no core \"IPU9\""));
  CHECK_THAT(outcome.err, Contains("did you mean \"front\"?"));
}
