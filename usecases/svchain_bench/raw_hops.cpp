#include <linux/futex.h>
#include <memory>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

#include "ipc/pause.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/pinned.h"
#include "usecases/svchain_bench/raw_ring.h"

namespace svchain::bench {

namespace {

constexpr size_t kCapacity = 64;

/// Somebody spins until there is something to do.
struct Spinning {
  void rung() {}
  template <class Ready>
  void until(Ready&& ready) {
    while (!ready()) ipc::pause();
  }
};

/// Somebody parks until there is something to do: a counter that rises with every change, and whether one
/// sleeps on it.
struct Parking {
  alignas(128) std::atomic<uint32_t> changes{0};
  std::atomic<uint32_t> asleep{0};

  void rung() {
    changes.fetch_add(1);
    if (asleep.load()) syscall(SYS_futex, &changes, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
  }
  template <class Ready>
  void until(Ready&& ready) {
    while (true) {
      const uint32_t seen = changes.load();
      if (ready()) return;
      asleep.store(1);
      syscall(SYS_futex, &changes, FUTEX_WAIT_PRIVATE, seen, nullptr, nullptr, 0);
      asleep.store(0);
    }
  }
};

/// A ring with whoever waits at its ends.
template <class Waiter>
struct Lane {
  RawRing ring{kCapacity};
  Waiter producer, consumer;

  void push(const ipc::Message& message) {
    producer.until([&] { return ring.push(message); });
    consumer.rung();
  }
  /// `tells`: the producer may be waiting for room.
  void pop(ipc::Message& message, bool tells) {
    consumer.until([&] { return ring.pop(message); });
    if (tells) producer.rung();
  }
};

template <class Waiter>
RoundTrips round_trips(int trips) {
  const Pinned pinned(0);
  auto there = std::make_unique<Lane<Waiter>>(), back = std::make_unique<Lane<Waiter>>();
  std::thread other([&] {
    pin(1);
    ipc::Message message;
    for (int i = 0; i < trips; ++i) {
      there->pop(message, false);
      back->push(message);
    }
  });
  RoundTrips measured(trips);
  ipc::Message message;
  for (int i = 0; i < trips; ++i) {
    measured.depart();
    there->push(message);
    back->pop(message, false);
  }
  other.join();
  return measured;
}

template <class Waiter>
double stream_ns(int messages) {
  const Pinned pinned(0);
  auto lane = std::make_unique<Lane<Waiter>>();
  std::thread other([&] {
    pin(1);
    ipc::Message message;
    for (int i = 0; i < messages; ++i) lane->pop(message, true);
  });
  const int64_t start_ns = now_ns();
  ipc::Message message;
  for (int i = 0; i < messages; ++i) lane->push(message);
  other.join();
  return static_cast<double>(now_ns() - start_ns) / messages;
}

}  // namespace

RoundTrips raw_ring_round_trips(int trips) {
  return round_trips<Spinning>(trips);
}

double raw_ring_stream_ns(int messages) {
  return stream_ns<Spinning>(messages);
}

RoundTrips raw_futex_round_trips(int trips) {
  return round_trips<Parking>(trips);
}

double raw_futex_stream_ns(int messages) {
  return stream_ns<Parking>(messages);
}

}  // namespace svchain::bench
