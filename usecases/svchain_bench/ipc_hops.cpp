#include <memory>
#include <thread>

#include "ipc/doorbell.h"
#include "ipc/mark.h"
#include "ipc/message.h"
#include "ipc/ring.h"
#include "ipc/shared_region.h"
#include "usecases/svchain_bench/our_hops.h"
#include "usecases/svchain_bench/pinned.h"

namespace svchain::bench {

namespace {

constexpr size_t kCapacity = 64;

/// One end: what it waits for rings its bell.
struct End {
  alignas(128) ipc::Doorbell bell;
  int spins = 0;

  /// Tries until it succeeds; whoever may make that so looks at the mark.
  template <class Try>
  void until(ipc::Mark& mark, Try&& attempt) {
    bool done = attempt();
    while (!done) {
      mark.set();
      done = attempt();
      if (!done && !bell.spin(spins, [&] { return done = attempt(); })) bell.park();
      bell.take();
    }
  }
};

struct Lane {
  ipc::SharedRegion region{"bench", ipc::Ring<ipc::Message>::bytes(kCapacity)};
  ipc::Ring<ipc::Message> ring = ipc::Ring<ipc::Message>::create(region.bytes().data(), kCapacity);
  ipc::Mark message, room;  // waited for

  void push(const ipc::Message& sent, End& producer, End& consumer) {
    producer.until(room, [&] { return ring.push(sent); });
    if (message.take()) consumer.bell.ring();
  }
  void pop(ipc::Message& received, End& producer, End& consumer) {
    consumer.until(message, [&] { return ring.pop(received); });
    if (room.take()) producer.bell.ring();
  }
};

}  // namespace

RoundTrips ipc_round_trips(int spins, int trips) {
  const Pinned pinned(0);
  Lane there, back;
  End near, far;
  near.spins = far.spins = spins;
  std::thread other([&] {
    pin(1);
    ipc::Message message;
    for (int i = 0; i < trips; ++i) {
      there.pop(message, near, far);
      back.push(message, far, near);
    }
  });
  RoundTrips measured(trips);
  ipc::Message message;
  for (int i = 0; i < trips; ++i) {
    measured.depart();
    there.push(message, near, far);
    back.pop(message, far, near);
  }
  other.join();
  return measured;
}

double ipc_stream_ns(int spins, int messages) {
  const Pinned pinned(0);
  Lane lane;
  End producer, consumer;
  producer.spins = consumer.spins = spins;
  std::thread other([&] {
    pin(1);
    ipc::Message message;
    for (int i = 0; i < messages; ++i) lane.pop(message, producer, consumer);
  });
  const int64_t start_ns = now_ns();
  const ipc::Message message;
  for (int i = 0; i < messages; ++i) lane.push(message, producer, consumer);
  other.join();
  return static_cast<double>(now_ns() - start_ns) / messages;
}

}  // namespace svchain::bench
