#include <thread>

#include "ipc/doorbell.h"
#include "ipc/evicting_ring.h"
#include "ipc/mark.h"
#include "ipc/message.h"
#include "ipc/ring.h"
#include "ipc/shared_region.h"
#include "tests/catch.h"

using namespace svchain::ipc;

TEST_CASE("a ring and a doorbell between two threads lose nothing and keep the order") {
  constexpr uint64_t kCount = 50'000;
  SharedRegion region("test", Ring<Message>::bytes(8));
  auto ring = Ring<Message>::create(region.bytes().data(), 8);
  Doorbell to_consumer, to_producer;
  Mark message_wanted, room_wanted;
  std::thread producer([&] {
    for (uint64_t n = 0; n < kCount; ++n) {
      Message m;
      m.sequence = n;
      m.timestamp_ns[7] = static_cast<int64_t>(~n);
      while (!ring.push(m)) {
        room_wanted.set();
        if (ring.push(m)) break;
        if (!to_producer.spin(10, [] { return false; })) to_producer.park();
        to_producer.take();
      }
      if (message_wanted.take()) to_consumer.ring();
    }
  });
  uint64_t wrong = 0;
  for (uint64_t n = 0; n < kCount; ++n) {
    Message m;
    while (!ring.pop(m)) {
      message_wanted.set();
      if (ring.pop(m)) break;
      if (!to_consumer.spin(10, [] { return false; })) to_consumer.park();
      to_consumer.take();
    }
    if (room_wanted.take()) to_producer.ring();
    wrong += m.sequence != n || m.timestamp_ns[7] != static_cast<int64_t>(~n) ? 1 : 0;
  }
  producer.join();
  CHECK(wrong == 0);
}

TEST_CASE("a producer that evicts and a consumer share every message between them, none twice, none torn") {
  constexpr uint64_t kCount = 100'000;
  SharedRegion region("test", EvictingRing<Message>::bytes(3));
  auto ring = EvictingRing<Message>::create(region.bytes().data(), 3);
  std::atomic<bool> done{false};
  uint64_t evicted = 0, torn = 0;
  std::thread producer([&] {
    for (uint64_t n = 0; n < kCount; ++n) {
      Message m;
      m.sequence = n;
      m.captured_ns = static_cast<int64_t>(n);
      m.timestamp_ns[7] = static_cast<int64_t>(n);
      Message oldest;
      while (!ring.push(m)) evicted += ring.pop(oldest) ? 1 : 0;
    }
    done = true;
  });
  uint64_t popped = 0, last = 0;
  bool rising = true;
  while (true) {
    const bool was_done = done;
    Message m;
    if (!ring.pop(m)) {
      if (was_done) break;
      std::this_thread::yield();
      continue;
    }
    rising = rising && (popped == 0 || m.sequence > last);
    last = m.sequence;
    ++popped;
    torn += m.captured_ns != static_cast<int64_t>(m.sequence) || m.timestamp_ns[7] != m.captured_ns ? 1 : 0;
  }
  producer.join();
  CHECK(torn == 0);
  CHECK(rising);
  CHECK(popped + evicted == kCount);
}
