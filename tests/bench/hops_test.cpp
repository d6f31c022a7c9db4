#include "tests/catch.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/our_hops.h"

using namespace svchain::bench;

TEST_CASE("every way to hop makes its round trips and measures them") {
  constexpr int kTrips = 50;
  CHECK(raw_ring_round_trips(kTrips).count() == kTrips - 1);
  CHECK(raw_futex_round_trips(kTrips).count() == kTrips - 1);
  CHECK(condition_variable_round_trips(kTrips).count() == kTrips - 1);
  CHECK(asio_round_trips(kTrips).count() == kTrips - 1);
  CHECK(ipc_round_trips(200, kTrips).count() == kTrips - 1);
  CHECK(chain_round_trips(200, kTrips).count() == kTrips - 1);
  CHECK(chain_round_trips(0, kTrips).count() == kTrips - 1);
}

TEST_CASE("every way to hop streams to the last message") {
  constexpr int kMessages = 500;
  CHECK(raw_ring_stream_ns(kMessages) > 0);
  CHECK(raw_futex_stream_ns(kMessages) > 0);
  CHECK(condition_variable_stream_ns(kMessages) > 0);
  CHECK(asio_stream_ns(kMessages) > 0);
  CHECK(ipc_stream_ns(0, kMessages) > 0);
  CHECK(chain_stream_ns(200, 2, kMessages) > 0);
}

TEST_CASE("a line of links on one core or two hands every frame to its end") {
  for (const int cores : {1, 2}) CHECK(chain_line_ns(256, cores, 50) > 0);
}
