#include <benchmark/benchmark.h>

#include "usecases/svchain_bench/benchmarks.h"
#include "usecases/svchain_bench/library_hops.h"
#include "usecases/svchain_bench/other_hops.h"
#include "usecases/svchain_bench/our_hops.h"

namespace svchain::bench {

namespace {

constexpr int kTrips = 20'000, kMessages = 200'000;
constexpr int kIterations = 5;

void add(const std::string& name, const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Iterations(kIterations)
      ->Unit(benchmark::kNanosecond);
}

void add_round_trip(const std::string& name, const std::function<RoundTrips(int)>& round_trips) {
  add("round_trip/" + name, [=](benchmark::State& state) {
    std::vector<double> late;
    for ([[maybe_unused]] auto _ : state) {
      const RoundTrips measured = round_trips(kTrips);
      state.SetIterationTime(measured.quantile_ns(0.5) * 1e-9);
      late.push_back(measured.quantile_ns(0.99));
    }
    state.counters["p99_ns"] = median(late);
  });
}

void add_time(const std::string& name, const std::function<double()>& time_ns) {
  add(name, [=](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) state.SetIterationTime(time_ns() * 1e-9);
  });
}

void add_stream(const std::string& name, const std::function<double(int)>& message_ns) {
  add_time("stream/" + name, [=] { return message_ns(kMessages); });
}

void add_ours() {
  for (const int spins : {200, 0}) {
    const std::string with = "/spins:" + std::to_string(spins);
    add_round_trip("ipc" + with, [=](int trips) { return ipc_round_trips(spins, trips); });
    add_round_trip("chain" + with, [=](int trips) { return chain_round_trips(spins, trips); });
    add_stream("ipc" + with, [=](int messages) { return ipc_stream_ns(spins, messages); });
    for (const int depth : {2, 64}) {
      add_stream("chain" + with + "/depth:" + std::to_string(depth),
                 [=](int messages) { return chain_stream_ns(spins, depth, messages); });
    }
  }
  for (const int cores : {1, 2}) {
    for (int links = 1; links <= 256; links *= 2) {
      const int frames = 200'000 / (links + 8);
      add_time("line/cores:" + std::to_string(cores) + "/links:" + std::to_string(links),
               [=] { return chain_line_ns(links, cores, frames); });
    }
  }
}

}  // namespace

void register_hop_benchmarks() {
  add_ours();
  add_round_trip("raw_ring", raw_ring_round_trips);
  add_round_trip("raw_futex", raw_futex_round_trips);
  add_round_trip("condition_variable", condition_variable_round_trips);
  add_round_trip("asio_post", asio_round_trips);
  add_stream("raw_ring", raw_ring_stream_ns);
  add_stream("raw_futex", raw_futex_stream_ns);
  add_stream("condition_variable", condition_variable_stream_ns);
  add_stream("asio_post", asio_stream_ns);
  if (const auto tbb = tbb_flow_graph()) add_stream("tbb_flow_graph", tbb->stream_ns);
  if (const auto gstreamer = gstreamer_queue()) add_stream("gstreamer_queue", gstreamer->stream_ns);
}

}  // namespace svchain::bench
