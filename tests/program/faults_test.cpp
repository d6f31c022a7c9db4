// --faults: what is wrong with a fault file is told before the run, beside all other faults.

#include "tests/catch.h"
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
