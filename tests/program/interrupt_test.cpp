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

}  // namespace

TEST_CASE("Ctrl-C delivers what was captured, writes the report and is no failure") {
  ends_in_good_order(SIGINT, {});
}

TEST_CASE("SIGTERM ends a run as Ctrl-C does") {
  ends_in_good_order(SIGTERM, {});
}

TEST_CASE("a virtual run is interrupted as well") {
  ends_in_good_order(SIGINT, {"--clock", "virtual"});
}
