#include "ipc/doorbell.h"

#include "ipc/mark.h"
#include "tests/catch.h"

using namespace svchain::ipc;
using namespace std::chrono_literals;

TEST_CASE("a bell rung before the wait is not lost") {
  Doorbell bell;
  bell.ring();
  CHECK_FALSE(bell.park());  // without a timeout: it would wait for ever if it were lost
  CHECK(bell.take() == 1);
}

TEST_CASE("a wait ends when its time is over") {
  Doorbell bell;
  CHECK(bell.park(1ms));
}

TEST_CASE("a wait whose time is over already does not park") {
  Doorbell bell;
  CHECK_FALSE(bell.park(0ns));
}

TEST_CASE("a bell that was rung while its waiter was parked is ready for the next wait") {
  Doorbell bell;
  for (int i = 0; i < 3; ++i) {
    CHECK(bell.park(1ms));  // and nobody rings
    CHECK(bell.take() == 0);
    bell.ring();
    bell.ring();
    CHECK_FALSE(bell.park());
    CHECK(bell.take() == 1);
  }
}

TEST_CASE("bells rung are taken together, each once") {
  Doorbell bell;
  bell.ring(3);
  bell.ring(Doorbell::kBells - 1);
  bell.ring(3);
  CHECK(bell.take() == (1u << 3 | 1u << (Doorbell::kBells - 1)));
  CHECK(bell.take() == 0);
}

TEST_CASE("a spin ends with a bell, or with what is seen to have come, or after its turns") {
  Doorbell bell;
  int looks = 0;
  CHECK_FALSE(bell.spin(5, [&] { return ++looks > 5; }));
  CHECK(looks == 5);
  CHECK(bell.spin(5, [&] { return ++looks > 7; }));
  CHECK(looks == 8);
  bell.ring();
  CHECK(bell.spin(1, [] { return false; }));
}

TEST_CASE("a mark is taken once for every time that it was set") {
  Mark mark;
  CHECK_FALSE(mark.take());
  mark.set();
  mark.set();
  CHECK(mark.take());
  CHECK_FALSE(mark.take());
}
