#pragma once
// Everything that is measured, as Google Benchmarks, names such as "round_trip/chain/spins:200". Times are
// per round trip, message or frame; medians within an iteration of many where so short.

namespace svchain::bench {

/// Once, before benchmark::RunSpecifiedBenchmarks().
void register_hop_benchmarks();
void register_surround_view_benchmarks();

}  // namespace svchain::bench
