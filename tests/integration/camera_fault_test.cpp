// Cameras that lose, repeat and delay frames: sync's policy decides, and the rest is never starved.

#include "tests/catch.h"
#include "tests/integration/surround_view.h"

using namespace svchain;
using namespace svchain::testing;

namespace {

void require_accounts_to_balance(const nlohmann::json& report) {
  uint64_t sum = report["frames"]["delivered"].get<uint64_t>();
  for (const auto& [reason, count] : report["frames"]["dropped"].items()) {
    CHECK(reason != "unfinished");
    sum += count.get<uint64_t>();
  }
  CHECK(report["frames"]["captured"] == sum);
  CHECK_FALSE(report.contains("failure"));
  for (const auto& [name, pool] : report["pools"].items()) {
    INFO(name);
    CHECK(pool["outstanding_at_stop"] == 0);
  }
}

nlohmann::json run_with(const SurroundView& world, const nlohmann::json& fault, const std::string& policy,
                        std::optional<uint64_t> seed = {}) {
  const auto text = SurroundView::with_camera_fault("2dsv_2dsp", "right", fault);
  return world.run(world.plan(text.dump(), "tda2x", {"sync.missing=" + policy}), 40, seed);
}

}  // namespace

TEST_CASE("a camera that dies and comes back does not hold up the others") {
  const SurroundView world;
  const nlohmann::json dies = {{"lose_from", 10}, {"lose_to", 24}};
  const auto repeated = run_with(world, dies, "repeat");
  require_accounts_to_balance(repeated);
  CHECK(repeated["frames"]["delivered"].get<int>() >= 39);
  const auto skipped = run_with(world, dies, "skip");
  require_accounts_to_balance(skipped);
  CHECK(skipped["frames"]["delivered"].get<int>() >=
        24);  // the first one back may come after its set was given up
  CHECK(skipped["frames"]["delivered"].get<int>() <= 25);
  CHECK(skipped["frames"]["dropped"].contains("sync_incomplete"));
}

TEST_CASE("a camera that never comes leaves its place empty and the others are delivered") {
  const SurroundView world;
  const auto report = run_with(world, {{"lose_from", 0}, {"lose_to", 1000}}, "repeat");
  require_accounts_to_balance(report);
  CHECK(report["frames"]["delivered"].get<int>() >= 30);
}

TEST_CASE("frames that come twice are used once") {
  const SurroundView world;
  const auto report = run_with(world, {{"twice_every", 3}}, "repeat");
  require_accounts_to_balance(report);
  CHECK(report["frames"]["delivered"] == 40);
}

TEST_CASE("jitter within delta costs nothing") {
  const SurroundView world;
  const auto report = run_with(world, {{"jitter_ms", 4}}, "skip");
  require_accounts_to_balance(report);
  CHECK(report["frames"]["delivered"] == 40);
}

TEST_CASE("what faults cost does not depend on the order in which the cores run") {
  const SurroundView world;
  const nlohmann::json faults = {{"lose_from", 5}, {"lose_to", 19}, {"twice_every", 4}, {"jitter_ms", 3}};
  const auto expected = run_with(world, faults, "repeat");
  require_accounts_to_balance(expected);
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    const auto report = run_with(world, faults, "repeat", seed);
    require_accounts_to_balance(report);
    CHECK(report["frames"]["delivered"] == expected["frames"]["delivered"]);
  }
}
