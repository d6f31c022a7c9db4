// The same frames give the same pixels, however the work is spread over cores and in whatever order it is
// done.

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;

TEST_CASE("every partition, the virtual clock and every seed deliver the same pixels") {
  const TemporaryFolder folder;
  write_json(folder.path() / "rig.json", small_rig());
  write_numbered(folder.path() / "input", 10);
  const auto sum = [&](const std::string& use_case, Arguments more) {
    more.insert(more.end(), {"--report", "-"});
    const auto outcome =
        svchain_program(small_run(use_case, folder.path() / "rig.json", folder.path() / "input", more));
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const Json report = Json::parse(outcome.out);
    CHECK(report["frames"]["delivered"] == 10);
    return report["output"]["sha256"].get<std::string>();
  };
  const std::string expected = sum("2dsv_2dsp", {});
  CHECK(expected.size() == 64);
  CHECK(sum("2dsv_1dsp", {}) == expected);
  CHECK(sum("2dsv_2dsp", {"--clock", "virtual"}) == expected);
  CHECK(sum("2dsv_1dsp", {"--clock", "virtual"}) == expected);
  for (const char* seed : {"1", "2", "3"}) {
    CHECK(sum("2dsv_2dsp", {"--clock", "virtual", "--seed", seed}) == expected);
  }
}

TEST_CASE("a folder as output holds every frame that was delivered") {
  const TemporaryFolder folder;
  write_json(folder.path() / "rig.json", small_rig());
  write_numbered(folder.path() / "input", 5);
  const auto outcome =
      svchain_program(small_run("2dsv_1dsp", folder.path() / "rig.json", folder.path() / "input",
                                {"--output", folder.path() / "frames"}));
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(count_of(folder.path() / "frames") == 5);
}
