#pragma once
// Runs a configured chain to its end, by hand on one thread under the virtual clock. (With threads a chain
// runs by itself: start it, and wait for finished().)

#include <cstdint>
#include <optional>

#include "framework/chain/chain.h"

namespace svchain {

/// Starts the chain, steps it until it is finished and stops it. Without a seed in one well-defined order;
/// with one in an order that the seed picks. A chain that stands still before its end fails with who waits
/// for whom.
void run_by_hand(Chain& chain, std::optional<uint64_t> seed = {});

/// The failure of a chain in which nothing moves any more.
Failure stall_of(Chain& chain);

}  // namespace svchain
