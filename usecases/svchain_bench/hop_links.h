#pragma once
// Links that do nothing but hand frames on, to see what handing on costs: ticker, pass, sink, ping. What they
// measure they leave with whoever made the catalogue.

#include "framework/link/catalogue.h"
#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

/// The sink's: from the last frame of the warm-up to the last of all.
struct Stretch {
  uint64_t warm_up = 0, last = 0;  // sequence numbers
  int64_t from_ns = 0, to_ns = 0;
  double per_frame_ns() const {
    return static_cast<double>(to_ns - from_ns) / static_cast<double>(last - warm_up);
  }
};

/// The links write to what is given, which has to outlive them. A ticker makes as many frames as the pace
/// says.
void add_hop_links(Catalogue& catalogue, Stretch& stretch, RoundTrips& round_trips);

}  // namespace svchain::bench
