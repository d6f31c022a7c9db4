#include "ipc/ring.h"

#include <cstring>

#include "ipc/evicting_ring.h"
#include "ipc/message.h"
#include "ipc/shared_region.h"
#include "tests/catch.h"

using namespace svchain::ipc;

namespace {

template <template <class> class AnyRing = Ring>
struct Fixture {
  explicit Fixture(size_t capacity)
      : region("test", AnyRing<Message>::bytes(capacity)),
        ring(AnyRing<Message>::create(region.bytes().data(), capacity)) {}
  static Message numbered(uint64_t n) {
    Message m;
    m.sequence = n;
    m.count = 1;
    m.buffers[0] = {static_cast<uint16_t>(n), static_cast<uint16_t>(n + 1)};
    m.timestamp_ns[7] = static_cast<int64_t>(n * n);
    return m;
  }
  SharedRegion region;
  AnyRing<Message> ring;
};

}  // namespace

TEST_CASE("a ring gives messages back whole and in order") {
  Fixture<> f(4);
  for (uint64_t round = 0; round < 10; ++round) {
    for (uint64_t n = 0; n < 4; ++n) REQUIRE(f.ring.push(Fixture<>::numbered(round * 4 + n)));
    for (uint64_t n = 0; n < 4; ++n) {
      Message m;
      REQUIRE(f.ring.pop(m));
      const Message expected = Fixture<>::numbered(round * 4 + n);
      CHECK(std::memcmp(&m, &expected, sizeof(m)) == 0);
    }
  }
}

TEST_CASE("a ring that evicts gives messages back whole and in order") {
  Fixture<EvictingRing> f(3);
  for (uint64_t n = 0; n < 10; ++n) {
    const Message sent = Fixture<>::numbered(n);
    REQUIRE(f.ring.push(sent));
    Message m;
    REQUIRE(f.ring.pop(m));
    CHECK(std::memcmp(&m, &sent, sizeof(m)) == 0);
  }
}

TEST_CASE("a full ring refuses and an empty one yields nothing") {
  Fixture<> f(2);
  Message m;
  CHECK_FALSE(f.ring.pop(m));
  CHECK(f.ring.front() == nullptr);
  CHECK(f.ring.push(Fixture<>::numbered(1)));
  CHECK(f.ring.push(Fixture<>::numbered(2)));
  CHECK_FALSE(f.ring.push(Fixture<>::numbered(3)));
  CHECK(f.ring.size() == 2);
}

TEST_CASE("a ring of any capacity holds just that many") {
  for (const size_t capacity : {1, 3, 5}) {
    Fixture<> f(capacity);
    for (size_t round = 0; round < 3; ++round) {
      for (size_t n = 0; n < capacity; ++n) CHECK(f.ring.push(Fixture<>::numbered(n)));
      CHECK_FALSE(f.ring.push({}));
      Message m;
      while (f.ring.pop(m)) {
      }
      CHECK(m.sequence == capacity - 1);
    }
  }
}

TEST_CASE("what is staged takes room, and is seen when it is published") {
  Fixture<> f(2);
  CHECK(f.ring.stage(Fixture<>::numbered(1)));
  CHECK(f.ring.stage(Fixture<>::numbered(2)));
  CHECK_FALSE(f.ring.stage(Fixture<>::numbered(3)));
  CHECK(f.ring.filled() == 2);
  CHECK(f.ring.front() == nullptr);
  f.ring.for_staged([](Message& m) { m.sent_ns = 5; });
  f.ring.publish();
  CHECK(f.ring.staged() == 0);
  Message m;
  REQUIRE(f.ring.pop(m));
  CHECK(m.sequence == 1);
  CHECK(m.sent_ns == 5);
}

TEST_CASE("looking leaves the message where it is") {
  Fixture<> f(2);
  f.ring.push(Fixture<>::numbered(7));
  REQUIRE(f.ring.front());
  CHECK(f.ring.front()->sequence == 7);
  CHECK(f.ring.size() == 1);
}

TEST_CASE("a producer can take the oldest message out of a full ring") {
  Fixture<EvictingRing> f(2);
  f.ring.push(Fixture<>::numbered(1));
  f.ring.push(Fixture<>::numbered(2));
  Message evicted;
  REQUIRE(f.ring.pop(evicted));
  CHECK(evicted.sequence == 1);
  CHECK(f.ring.push(Fixture<>::numbered(3)));
  Message m;
  REQUIRE(f.ring.pop(m));
  CHECK(m.sequence == 2);
}

TEST_CASE("a second view of the same memory sees the same ring") {
  Fixture<> f(4);
  auto other = Ring<Message>::attach(f.region.bytes().data());
  f.ring.push(Fixture<>::numbered(5));
  Message m;
  REQUIRE(other.pop(m));
  CHECK(m.sequence == 5);
  CHECK(f.ring.empty());
}
