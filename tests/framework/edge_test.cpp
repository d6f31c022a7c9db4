#include "framework/chain/edge.h"

#include <utility>

#include "ipc/doorbell.h"
#include "tests/catch.h"

using namespace svchain;

namespace {

/// An edge between two cores that carries messages without buffers, and how often either core was rung.
struct TwoCores {
  explicit TwoCores(int depth)
      : edge("a.out -> b.in", depth, Policy::kBlock, {.core = 0, .doorbell = &producer},
             {.core = 1, .doorbell = &consumer}, clock) {}

  /// Whether the bell has been rung since it was asked last.
  static bool rung(const ipc::Doorbell& bell, uint32_t& seen) {
    return std::exchange(seen, bell.epoch()) != bell.epoch();
  }
  bool producer_rung() { return rung(producer, producer_seen); }
  bool consumer_rung() { return rung(consumer, consumer_seen); }

  VirtualClock clock;
  ipc::Doorbell producer, consumer;
  uint32_t producer_seen = 0, consumer_seen = 0;
  Edge edge;
};

}  // namespace

TEST_CASE("a message that comes to an empty edge rings its consumer, one that finds others there does not") {
  TwoCores cores(3);
  cores.edge.send({});
  CHECK(cores.consumer_rung());
  cores.edge.send({});
  CHECK_FALSE(cores.consumer_rung());
  ipc::Message message;
  CHECK(cores.edge.take(message));
  CHECK(cores.edge.take(message));
  cores.edge.send({});
  CHECK(cores.consumer_rung());
}

TEST_CASE("the end of the stream rings its consumer") {
  TwoCores cores(1);
  cores.edge.send({});
  ipc::Message message;
  CHECK(cores.consumer_rung());
  CHECK(cores.edge.take(message));
  cores.edge.send_end();
  CHECK(cores.consumer_rung());
}

TEST_CASE("a message taken from a full edge rings its producer, one from an edge with room does not") {
  TwoCores cores(2);
  cores.edge.send({});
  cores.edge.send({});
  CHECK(cores.edge.room() == 0);
  ipc::Message message;
  CHECK(cores.edge.take(message));
  CHECK(cores.producer_rung());
  CHECK(cores.edge.take(message));
  CHECK_FALSE(cores.producer_rung());
}
