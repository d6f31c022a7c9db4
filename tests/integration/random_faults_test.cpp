// Random faults of all kinds in modelled time, seed by seed: nothing stands still, nothing is lost uncounted,
// and a chain is back to full rate within a second.

#include <cstdlib>

#include "tests/catch.h"
#include "tests/integration/faulty_run.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

/// Faults from the end of power-up to some seconds before the end, often several at a time.
FaultyRun random_run(const std::string& use_case, uint64_t seed, double lasting_s) {
  FaultyRun run;
  run.use_case = use_case;
  run.lasting_s = lasting_s;
  run.seed = seed;
  run.random = {{"per_hour", 900}, {"from_s", 8}, {"to_s", lasting_s - 5}, {"lasting_s", {0.05, 2}}};
  return run;
}

/// For more seeds, or to replay one.
uint64_t number_from(const char* variable, uint64_t fallback) {
  const char* text = std::getenv(variable);
  return text ? std::stoull(text) : fallback;
}

}  // namespace

TEST_CASE("random faults of a seed make the same report to the byte, and another seed others") {
  const SurroundView world;
  const auto text = [&](uint64_t seed) {
    return run_modelled(world, random_run("2dsv_2dsp", seed, 60)).dump();
  };
  CHECK(text(5) == text(5));
  CHECK(text(5) != text(6));
}

TEST_CASE("whatever breaks, every frame is delivered or counted, and full rate is back within a second") {
  const SurroundView world;
  const uint64_t first = number_from("SVCHAIN_FIRST_SEED", 1), count = number_from("SVCHAIN_SEEDS", 12);
  for (const std::string use_case : {"2dsv_2dsp", "2dsv_1dsp", "3dsv", "2d3dsv"}) {
    for (uint64_t seed = first; seed < first + count; ++seed) {
      INFO("SVCHAIN_FIRST_SEED=" << seed << " SVCHAIN_SEEDS=1 for " << use_case);
      const auto report = run_modelled(world, random_run(use_case, seed, 300));
      CHECK(report.value("failure", "") == "");
      CHECK(unbalanced(report) == "");
      CHECK(report["faults"]["recovery"]["slowest_s"].get<double>() < 1);
      CHECK(report["frames"]["delivered"].get<int>() > 300 * 30 / 2);
    }
  }
}
