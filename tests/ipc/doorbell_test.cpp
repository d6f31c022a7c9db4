#include "ipc/doorbell.h"

#include "tests/catch.h"

using namespace svchain::ipc;
using namespace std::chrono_literals;

TEST_CASE("a bell rung before the wait is not lost") {
  Doorbell bell;
  const uint32_t seen = bell.epoch();
  bell.ring();
  CHECK_FALSE(bell.wait(seen, 0, std::nullopt));  // without a timeout: it would wait for ever if it were lost
  CHECK(bell.epoch() != seen);
}

TEST_CASE("a wait ends when its time is over") {
  Doorbell bell;
  CHECK(bell.wait(bell.epoch(), 1, 1ms));
}

TEST_CASE("a wait whose time is over already does not park") {
  Doorbell bell;
  CHECK_FALSE(bell.wait(bell.epoch(), 1, 0ns));
}

TEST_CASE("a bell that was rung while its waiter was parked is ready for the next wait") {
  Doorbell bell;
  for (int i = 0; i < 3; ++i) {
    const uint32_t seen = bell.epoch();
    CHECK(bell.wait(seen, 0, 1ms));  // parks, and nobody rings
    CHECK(bell.epoch() == seen);
    bell.ring();
    bell.ring();
    CHECK(bell.epoch() != seen);
    CHECK_FALSE(bell.wait(seen, 0, std::nullopt));
  }
}
