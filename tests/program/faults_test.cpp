// --faults: what is wrong with a fault file is told before the run, beside all other faults.

#include "tests/catch.h"
#include "tests/json_schema.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

const Arguments kShortRun = {"--usecase", "2dsv_2dsp", "--frames", "2", "--clock", "virtual", "--no-pixels"};

Outcome run_with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return svchain_program(arguments);
}

}  // namespace

TEST_CASE("all faults of a fault file and of the other options are told at once, with status 2") {
  const TemporaryFolder folder;
  write_text(folder.path() / "bad.json",
             "{\"faults\": [\n{\"kind\": \"halts\", \"at\": \"DSP1\"},\n{\"kind\": \"late\", \"at\": "
             "\"dup.out1\"}]}");
  const auto outcome = run_with(kShortRun, {"--faults", folder.path() / "bad.json", "--rig", "nowhere.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("bad.json:2:10: error: /faults/0/kind") && Contains("did you mean \"halt\"?"));
  CHECK_THAT(outcome.err, Contains("bad.json:3:1: error: /faults/1: \"late_ms\" is missing"));
  CHECK_THAT(outcome.err, Contains("nowhere.json"));
}

TEST_CASE("places that the use case lacks are told at their entries, with status 2") {
  const TemporaryFolder folder;
  write_text(folder.path() / "bad.json",
             "{\"faults\": [\n{\"kind\": \"halt\", \"at\": \"EVE1\"},\n{\"kind\": \"throw\", \"at\": "
             "\"synthesys\"}]}");
  const auto outcome = run_with(kShortRun, {"--faults", folder.path() / "bad.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("bad.json:2:1: error: /faults/0") && Contains("needs a core in use"));
  CHECK_THAT(outcome.err,
             Contains("bad.json:3:1: error: /faults/1") && Contains("did you mean \"synthesis\"?"));
}

TEST_CASE("an unknown name of a fault file is answered with those there are") {
  const auto outcome = run_with(kShortRun, {"--faults", "randm"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err,
             Contains("--faults: error: unknown fault file \"randm\", did you mean \"random\"?") &&
                 Contains("failing_parts"));
}

TEST_CASE("validate tells what is wrong with a fault file") {
  const TemporaryFolder folder;
  write_text(folder.path() / "bad.json", R"({"random": {"per_hour": 1}})");
  const auto outcome = svchain_program({"validate", folder.path() / "bad.json"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("bad.json:1:12: error: /random: \"to_s\" is missing"));
}

TEST_CASE("a seed does nothing without virtual time and without faults, and the program says so") {
  const TemporaryFolder folder;
  write_json(folder.path() / "rig.json", small_rig());
  write_stills(folder.path() / "input");
  const auto run = [&](Arguments more) {
    more.insert(more.end(), {"--frames", "2", "--seed", "3"});
    return svchain_program(small_run("2dsv_2dsp", folder.path() / "rig.json", folder.path() / "input", more));
  };
  CHECK_THAT(run({}).err, Contains("--seed picks the order"));
  const auto with_faults = run({"--faults", "random"});
  CHECK(with_faults.status == 0);
  CHECK_THAT(with_faults.err, !Contains("--seed"));
}

TEST_CASE("a run in which parts fail ends well, every fault strikes, and its report fits the schema") {
  const auto outcome =
      svchain_program({"--usecase", "2dsv_2dsp", "--clock", "virtual", "--no-pixels", "--fps", "30",
                       "--frames", "1200", "--faults", "failing_parts", "--report", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json faults = Json::parse(outcome.out)["faults"];
  CHECK(faults["seed"] == 1);
  CHECK(faults["recovery"]["slowest_s"].get<double>() < 1);
  CHECK(faults["list"].size() == 12);
  for (const Json& fault : faults["list"]) {
    INFO(fault.dump());
    CHECK(fault["times"] > 0);
  }
  if (!has_schema_validator()) return;
  CHECK(fits_schema("report", outcome.out));
  Json wrong = Json::parse(outcome.out);
  wrong["faults"]["list"][0]["kind"] = "nothing";
  CHECK_FALSE(fits_schema("report", wrong.dump()));
}

TEST_CASE("a link that throws ends the run with status 1, and costs its frames where --set says so") {
  const TemporaryFolder folder;
  write_text(folder.path() / "throw.json",
             R"({"faults": [{"kind": "throw", "at": "synthesis", "from_s": 8, "to_s": 9}]})");
  const auto run = [&](const Arguments& more) {
    Arguments all = {"--usecase",
                     "2dsv_2dsp",
                     "--clock",
                     "virtual",
                     "--no-pixels",
                     "--fps",
                     "30",
                     "--frames",
                     "300",
                     "--faults",
                     folder.path() / "throw.json",
                     "--report",
                     "-"};
    all.insert(all.end(), more.begin(), more.end());
    return svchain_program(all);
  };
  const auto stopped = run({});
  CHECK(stopped.status == 1);
  CHECK_THAT(stopped.err, Contains("synthesis") && Contains("a fault of the fault file"));
  const auto dropped = run({"--set", "synthesis.on_error=drop"});
  INFO(dropped.err);
  REQUIRE(dropped.status == 0);
  const Json report = Json::parse(dropped.out);
  CHECK(report["frames"]["dropped"]["error"] == report["faults"]["list"][0]["times"]);
}
