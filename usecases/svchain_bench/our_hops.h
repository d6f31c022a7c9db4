#pragma once
// Hops by our own means: through the rings and doorbells alone (ipc), and through whole chains by their
// public interface, with pools, accounts, statistics and all. Measured like those in other_hops.h. `spins`:
// how often a core looks at its doorbell before it parks. Throws std::runtime_error where a chain fails.

#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

/// A ring each way with a doorbell for either end.
RoundTrips ipc_round_trips(int spins, int trips);
double ipc_stream_ns(int spins, int messages);

/// Two links on two cores, the second sends back what the first has sent. From one call of the first to its
/// next.
RoundTrips chain_round_trips(int spins, int trips);
/// A source on one core and a sink on another, an edge of this depth between. Buffers go home one by one.
double chain_stream_ns(int spins, int depth, int messages);

/// Time per frame of a source, this many links that hand it on and a sink, all on one core, or every one on
/// the other core than the one before. A frame has so many buffers, as a set has cameras.
double chain_line_ns(int links, int cores, int frames, int buffers = 1);

}  // namespace svchain::bench
