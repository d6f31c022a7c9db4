#include "usecases/svchain_bench/comparisons.h"
#include "usecases/svchain_bench/library_hops.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/our_hops.h"

namespace svchain::bench {

namespace {

constexpr int kRounds = 15;
constexpr int kSpins = 200;  // what a core of a SoC file has
constexpr int kParks = 0;
constexpr int kSpinningTrips = 20'000, kParkingTrips = 4'000;
constexpr int kStreamed = 200'000;
constexpr int kDepth = 64;

Cost median_trip(RoundTrips (*trips)(int), int count) {
  return [=] { return trips(count).quantile_ns(0.5); };
}

Cost median_trip(RoundTrips (*trips)(int, int), int spins, int count) {
  return [=] { return trips(spins, count).quantile_ns(0.5); };
}

/// What one link more on the same core costs a frame.
double same_core_ns() {
  constexpr int kLinks = 16, kFrames = 20'000;
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) {
    const double one = chain_line_ns(1, 1, kFrames);
    rounds.push_back((chain_line_ns(1 + kLinks, 1, kFrames) - one) / kLinks);
  }
  return median(rounds);
}

}  // namespace

void compare_hops(Results& results, const Progress& progress) {
  const auto compare = [&](const std::string& name, const Cost& a, const Cost& b) {
    progress(name);
    results.ratios[name] = measure_paired(kRounds, a, b);
  };
  const Cost ring = median_trip(raw_ring_round_trips, kSpinningTrips);
  const Cost futex = median_trip(raw_futex_round_trips, kParkingTrips);
  compare("hop.spin_park_rtt_over_raw_ring", median_trip(chain_round_trips, kSpins, kSpinningTrips), ring);
  compare("hop.ipc_spin_park_rtt_over_raw_ring", median_trip(ipc_round_trips, kSpins, kSpinningTrips), ring);
  compare("hop.parked_rtt_over_raw_futex", median_trip(chain_round_trips, kParks, kParkingTrips), futex);
  compare("hop.ipc_parked_rtt_over_raw_futex", median_trip(ipc_round_trips, kParks, kParkingTrips), futex);

  const Cost stream = [] { return chain_stream_ns(kSpins, kDepth, kStreamed); };
  const Cost ipc_stream = [] { return ipc_stream_ns(kSpins, kStreamed); };
  const Cost asio = [] { return asio_stream_ns(kStreamed); };
  compare("hop.stream_vs_asio_post", asio, stream);
  compare("hop.ipc_stream_vs_asio_post", asio, ipc_stream);
  compare(
      "hop.stream_vs_condition_variable", [] { return condition_variable_stream_ns(kStreamed); }, stream);
  const auto compare_library = [&](const std::string& name, const std::optional<Library>& library) {
    if (library)
      compare(
          name, [&] { return library->stream_ns(kStreamed); }, stream);
    else
      results.missing[name] = "not installed";
  };
  compare_library("hop.stream_vs_tbb_flow_graph", tbb_flow_graph());
  compare_library("hop.stream_vs_gstreamer_queue", gstreamer_queue());
  progress("hop.same_core_ns");
  results.figures["hop.same_core_ns"] = same_core_ns();
}

}  // namespace svchain::bench
