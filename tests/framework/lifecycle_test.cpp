#include "framework/chain/lifecycle.h"

#include "tests/catch.h"

using namespace svchain;
using S = ChainState;
using A = ChainAction;

TEST_CASE("a chain's life allows exactly these transitions") {
  struct Row {
    S state;
    std::optional<S> configure, start, drain, stop;
  };
  const Row table[] = {
      {S::kCreated, S::kConfigured, {}, {}, S::kStopped}, {S::kConfigured, {}, S::kRunning, {}, S::kStopped},
      {S::kRunning, {}, {}, S::kDraining, S::kStopped},   {S::kDraining, {}, {}, S::kDraining, S::kStopped},
      {S::kStopped, S::kConfigured, {}, {}, S::kStopped},
  };
  for (const Row& row : table) {
    INFO(name_of(row.state));
    CHECK(next_state(row.state, A::kConfigure) == row.configure);
    CHECK(next_state(row.state, A::kStart) == row.start);
    CHECK(next_state(row.state, A::kDrain) == row.drain);
    CHECK(next_state(row.state, A::kStop) == row.stop);
  }
}
