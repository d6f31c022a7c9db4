#include <memory>
#include <thread>

#include "ipc/doorbell.h"
#include "ipc/message.h"
#include "ipc/ring.h"
#include "ipc/shared_region.h"
#include "usecases/svchain_bench/our_hops.h"

namespace svchain::bench {

namespace {

constexpr size_t kCapacity = 64;

/// One end: what it waits for rings its bell.
struct End {
  alignas(128) ipc::Doorbell bell;
  int spins = 0;

  template <class Ready>
  void until(Ready&& ready) {
    while (true) {
      const uint32_t seen = bell.epoch();
      if (ready()) return;
      bell.wait(seen, spins, std::nullopt);
    }
  }
};

struct Lane {
  ipc::SharedRegion region{"bench", ipc::Ring<ipc::Message>::bytes(kCapacity)};
  ipc::Ring<ipc::Message> ring = ipc::Ring<ipc::Message>::create(region.bytes().data(), kCapacity);
};

}  // namespace

RoundTrips ipc_round_trips(int spins, int trips) {
  Lane there, back;
  End near, far;
  near.spins = far.spins = spins;
  std::thread other([&] {
    ipc::Message message;
    for (int i = 0; i < trips; ++i) {
      far.until([&] { return there.ring.pop(message); });
      back.ring.push(message);
      near.bell.ring();
    }
  });
  RoundTrips measured(trips);
  ipc::Message message;
  for (int i = 0; i < trips; ++i) {
    measured.depart();
    there.ring.push(message);
    far.bell.ring();
    near.until([&] { return back.ring.pop(message); });
  }
  other.join();
  return measured;
}

double ipc_stream_ns(int spins, int messages) {
  Lane lane;
  End producer, consumer;
  producer.spins = consumer.spins = spins;
  std::thread other([&] {
    ipc::Message message;
    for (int i = 0; i < messages; ++i) {
      consumer.until([&] { return lane.ring.pop(message); });
      if (lane.ring.size() + 1 >= kCapacity) producer.bell.ring();
    }
  });
  const int64_t start_ns = now_ns();
  const ipc::Message message;
  for (int i = 0; i < messages; ++i) {
    producer.until([&] { return lane.ring.push(message); });
    if (lane.ring.size() <= 1) consumer.bell.ring();
  }
  other.join();
  return static_cast<double>(now_ns() - start_ns) / messages;
}

}  // namespace svchain::bench
