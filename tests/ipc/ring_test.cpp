#include "ipc/ring.h"

#include <vector>

#include "ipc/message.h"
#include "ipc/shared_region.h"
#include "tests/catch.h"

using namespace svchain::ipc;

namespace {

struct Fixture {
  explicit Fixture(size_t capacity)
      : region("test", Ring<Message>::bytes(capacity)),
        ring(Ring<Message>::create(region.bytes().data(), capacity)) {}
  static Message numbered(uint64_t n) {
    Message m;
    m.sequence = n;
    m.count = 1;
    m.buffers[0] = {static_cast<uint16_t>(n), static_cast<uint16_t>(n + 1)};
    m.timestamp_ns[7] = static_cast<int64_t>(n * n);
    return m;
  }
  SharedRegion region;
  Ring<Message> ring;
};

}  // namespace

TEST_CASE("a ring gives messages back whole and in order") {
  Fixture f(4);
  for (uint64_t round = 0; round < 10; ++round) {
    for (uint64_t n = 0; n < 4; ++n) REQUIRE(f.ring.push(Fixture::numbered(round * 4 + n)));
    for (uint64_t n = 0; n < 4; ++n) {
      Message m;
      REQUIRE(f.ring.pop(m));
      const Message expected = Fixture::numbered(round * 4 + n);
      CHECK(std::memcmp(&m, &expected, sizeof(m)) == 0);
    }
  }
}

TEST_CASE("a full ring refuses and an empty one yields nothing") {
  Fixture f(2);
  Message m;
  CHECK_FALSE(f.ring.pop(m));
  CHECK_FALSE(f.ring.peek(m));
  CHECK(f.ring.push(Fixture::numbered(1)));
  CHECK(f.ring.push(Fixture::numbered(2)));
  CHECK_FALSE(f.ring.push(Fixture::numbered(3)));
  CHECK(f.ring.size() == 2);
}

TEST_CASE("peeking leaves the message where it is") {
  Fixture f(2);
  f.ring.push(Fixture::numbered(7));
  Message m;
  REQUIRE(f.ring.peek(m));
  CHECK(m.sequence == 7);
  CHECK(f.ring.size() == 1);
}

TEST_CASE("a producer can take the oldest message out of a full ring") {
  Fixture f(2);
  f.ring.push(Fixture::numbered(1));
  f.ring.push(Fixture::numbered(2));
  Message evicted;
  REQUIRE(f.ring.pop(evicted));
  CHECK(evicted.sequence == 1);
  CHECK(f.ring.push(Fixture::numbered(3)));
  Message m;
  REQUIRE(f.ring.pop(m));
  CHECK(m.sequence == 2);
}

TEST_CASE("a second view of the same memory sees the same ring") {
  Fixture f(4);
  auto other = Ring<Message>::attach(f.region.bytes().data());
  f.ring.push(Fixture::numbered(5));
  Message m;
  REQUIRE(other.pop(m));
  CHECK(m.sequence == 5);
  CHECK(f.ring.empty());
}
