// Ctrl-C and SIGTERM end a run in good order.

#include <csignal>
#include <regex>

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;

namespace {

bool frames_went_by(const std::string& said) {
  return std::regex_search(said, std::regex("[1-9][0-9]* frames, "));
}

void ends_in_good_order(int signal, const Arguments& more) {
  const TemporaryFolder folder;
  write_json(folder.path() / "rig.json", small_rig());
  write_stills(folder.path() / "input");
  Arguments arguments = {"--frames", "1000000000",
                         "--output", folder.path() / "view.png",
                         "--report", folder.path() / "report.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto outcome = svchain_interrupted(
      small_run("2dsv_2dsp", folder.path() / "rig.json", folder.path() / "input", arguments), signal,
      frames_went_by);
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(std::filesystem::exists(folder.path() / "view.png"));
  REQUIRE(std::filesystem::exists(folder.path() / "report.json"));
  CHECK(count_of(folder.path()) == 4);  // and nothing temporary
  const Json report = Json::parse(read_text(folder.path() / "report.json"));
  CHECK(report["frames"]["captured"] > 0);
  CHECK(report["frames"]["captured"] == report["frames"]["delivered"]);
  for (const auto& [name, pool] : report["pools"].items()) CHECK(pool["outstanding_at_stop"] == 0);
}

/// Frames counted on the last line of progress; 0 before the first.
long long frames_of(const std::string& said) {
  const std::regex progress("([0-9]+) frames, ");
  long long frames = 0;
  for (std::sregex_iterator line(said.begin(), said.end(), progress), end; line != end; ++line)
    frames = std::stoll((*line)[1]);
  return frames;
}

/// A run that gets SIGUSR1 when frames go by, and Ctrl-C 20 frames after it has said `answer` to that.
Outcome recalibrated(const std::string& source, const std::string& answer,
                     const std::filesystem::path& report) {
  return svchain_signalled({"--usecase", "2dsv_2dsp", "--input", "simulated:parking", "--frames",
                            "1000000000", "--set", "view.size_px=[220,270]", "--set",
                            "geometric_alignment.source=" + source, "--output", "none", "--report", report},
                           {{SIGUSR1, frames_went_by}, {SIGINT, [&](const std::string& said) {
                                                          const auto answered = said.find(answer);
                                                          if (answered == std::string::npos) return false;
                                                          return frames_of(said) >
                                                                 frames_of(said.substr(0, answered)) + 20;
                                                        }}});
}

}  // namespace

TEST_CASE("SIGUSR1 has the geometry aligned anew while frames go on") {
  const TemporaryFolder folder;
  const auto outcome = recalibrated("charts", "geometric_alignment: recalibrate: with the next complete set",
                                    folder.path() / "report.json");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json report = Json::parse(read_text(folder.path() / "report.json"));
  CHECK(report["geometric_alignment"]["luts"].get<int>() +
            report["geometric_alignment"]["rejected_while_running"].get<int>() ==
        2);
  CHECK(report["frames"]["captured"] == report["frames"]["delivered"]);
}

TEST_CASE("SIGUSR1 where nothing aligns by frames says so, and the run goes on") {
  const TemporaryFolder folder;
  const auto outcome =
      recalibrated("rig", "geometric_alignment: recalibrate refused: source rig looks at no frames",
                   folder.path() / "report.json");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json report = Json::parse(read_text(folder.path() / "report.json"));
  CHECK(report["geometric_alignment"]["luts"] == 1);
}

TEST_CASE("Ctrl-C delivers what was captured, writes the report and is no failure") {
  ends_in_good_order(SIGINT, {});
}

TEST_CASE("SIGTERM ends a run as Ctrl-C does") {
  ends_in_good_order(SIGTERM, {});
}

TEST_CASE("a virtual run is interrupted as well") {
  ends_in_good_order(SIGINT, {"--clock", "virtual"});
}
