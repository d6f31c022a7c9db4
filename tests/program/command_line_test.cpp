// The command line itself.

#include "tests/catch.h"
#include "tests/program/small_input.h"
#include "tests/test_data.h"

using namespace svchain::testing;
using Catch::Matchers::Contains;

TEST_CASE("an unknown option is answered with the one that was probably meant") {
  const auto outcome = svchain_program({"--usecase", "2dsv_2dsp", "--inptu", "somewhere"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("unknown option \"--inptu\", did you mean \"--input\"?"));
}

TEST_CASE("an unknown command is answered with the known ones") {
  const auto outcome = svchain_program({"simulat", "--scene", "parking"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("unknown command \"simulat\", did you mean \"simulate\"?") &&
                              Contains("list, validate, graph, schema"));
}

TEST_CASE("bad numbers are answered with the range, all of them at once") {
  const auto outcome = svchain_program(
      {"--usecase", "2dsv_2dsp", "--frames", "0", "--fps", "fast", "--seed", "1.5", "--clock", "virtuel"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--frames: error: expected a whole number") && Contains("got \"0\""));
  CHECK_THAT(outcome.err, Contains("--fps: error:") && Contains("--seed: error:"));
  CHECK_THAT(outcome.err,
             Contains("--clock: error: expected steady or virtual") && Contains("did you mean \"virtual\"?"));
}

TEST_CASE("an option without its value is bad usage") {
  const auto outcome = svchain_program({"--usecase"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--usecase"));
}

TEST_CASE("without anything to do the program says what it needs") {
  const auto outcome = svchain_program({});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("--usecase: error: missing") && Contains("2dsv_2dsp"));
}

TEST_CASE("help names the commands and options there are") {
  const auto outcome = svchain_program({"--help"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("validate") && Contains("calibrate") && Contains("--usecase") &&
                              Contains("--report") && Contains("--faults"));
}
