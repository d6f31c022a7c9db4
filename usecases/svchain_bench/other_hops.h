#pragma once
// Hops between two threads by other means than ours, each as its users would write it. A round trip is a
// message that the other thread sends straight back; a stream is messages one way, as fast as they go, until
// the last has come. All carry ipc::Message, 128 bytes. Every call makes its threads, runs, and ends them.

#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

/// Ring, both ends spinning.
RoundTrips raw_ring_round_trips(int trips);
double raw_ring_stream_ns(int messages);
/// The same ring; who has nothing to do parks on a futex at once.
RoundTrips raw_futex_round_trips(int trips);
double raw_futex_stream_ns(int messages);
/// Bounded queue under a mutex, a condition variable each way.
RoundTrips condition_variable_round_trips(int trips);
double condition_variable_stream_ns(int messages);
/// boost::asio::post between two io_contexts with one thread each.
RoundTrips asio_round_trips(int trips);
double asio_stream_ns(int messages);

}  // namespace svchain::bench
