#include "framework/chain/edge.h"

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
  bool producer_rung() { return producer.take() != 0; }
  bool consumer_rung() { return consumer.take() != 0; }
  /// A call that sends one message.
  void send() {
    edge.send({});
    edge.publish(0);
  }
  bool take() {
    if (!edge.front()) return false;
    edge.pop(0);
    return true;
  }

  VirtualClock clock;
  ipc::Doorbell producer, consumer;
  Edge edge;
};

}  // namespace

TEST_CASE("a message rings a consumer that has found none, and no other") {
  TwoCores cores(3);
  cores.send();
  CHECK_FALSE(cores.consumer_rung());  // it has not looked yet
  CHECK(cores.take());
  CHECK_FALSE(cores.take());
  cores.send();
  CHECK(cores.consumer_rung());
  cores.send();
  CHECK_FALSE(cores.consumer_rung());
  CHECK(cores.take());
  CHECK(cores.take());
  CHECK_FALSE(cores.take());
  cores.send();
  CHECK(cores.consumer_rung());
}

TEST_CASE("what a call sends to another core leaves when the call ends") {
  TwoCores cores(3);
  CHECK_FALSE(cores.take());
  cores.edge.send({});
  cores.edge.send({});
  CHECK(cores.edge.room() == 1);
  CHECK_FALSE(cores.consumer_rung());
  CHECK_FALSE(cores.take());
  cores.edge.publish(7);
  CHECK(cores.consumer_rung());
  REQUIRE(cores.edge.front());
  CHECK(cores.edge.front()->sent_ns == 7);
  CHECK(cores.take());
  CHECK(cores.take());
}

TEST_CASE("the end of the stream rings its consumer") {
  TwoCores cores(1);
  cores.send();
  CHECK(cores.take());
  CHECK_FALSE(cores.take());
  cores.edge.send_end();
  cores.edge.publish(0);
  CHECK(cores.consumer_rung());
}

TEST_CASE("room rings a producer that has found none, and no other") {
  TwoCores cores(2);
  cores.send();
  cores.send();
  CHECK(cores.take());
  CHECK_FALSE(cores.producer_rung());  // it has not looked yet
  cores.send();
  CHECK_FALSE(cores.edge.has_room());
  CHECK(cores.take());
  CHECK(cores.producer_rung());
  CHECK(cores.edge.has_room());
  CHECK(cores.take());
  CHECK_FALSE(cores.producer_rung());
}
