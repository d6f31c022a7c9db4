#include "framework/chain/chain.h"
#include "usecases/svchain_bench/faults.h"
#include "usecases/svchain_bench/hop_links.h"
#include "usecases/svchain_bench/our_hops.h"
#include "usecases/svchain_bench/threaded_run.h"

namespace svchain::bench {

namespace {

using Json = nlohmann::json;

Json two_cores(int spins) {
  const Json core = {{"kind", "A15"}, {"spins", spins}};
  return {{"name", "duo"}, {"cores", {{"A", core}, {"B", core}}}, {"roles", {{"host", "A"}}}};
}

/// Runs to the end on threads.
void run(const Json& use_case, int spins, int frames, Stretch& stretch, RoundTrips& round_trips) {
  Catalogue catalogue;
  add_hop_links(catalogue, stretch, round_trips);
  Plan plan = value_or_throw(make_plan(value_or_throw(parse_use_case(use_case.dump(), "hops", catalogue)),
                                       value_or_throw(parse_soc(two_cores(spins).dump(), "duo")), catalogue));
  Pace pace;
  pace.frames = static_cast<uint64_t>(frames);
  run_on_threads(std::move(plan), pace);
}

Stretch stretch_of(int frames) {
  Stretch stretch;
  stretch.warm_up = static_cast<uint64_t>(frames / 10);
  stretch.last = static_cast<uint64_t>(frames - 1);
  return stretch;
}

double per_frame_ns(const Json& use_case, int spins, int frames) {
  Stretch stretch = stretch_of(frames);
  RoundTrips none(0);
  run(use_case, spins, frames, stretch, none);
  return stretch.per_frame_ns();
}

Json link(const std::string& type, const std::string& core) {
  return {{"type", type}, {"core", core}, {"params", {{"end", core == "B" ? 1 : 0}}}};
}

}  // namespace

RoundTrips chain_round_trips(int spins, int trips) {
  const Json feedback = {{"from", "pong.out"}, {"to", "ping.back"}, {"feedback", true}};
  const Json use_case = {{"name", "round_trip"},
                         {"links",
                          {{"ticker", link("ticker", "A")},
                           {"ping", link("ping", "A")},
                           {"pong", link("pass", "B")},
                           {"sink", link("sink", "A")}}},
                         {"edges", Json::array({"ticker.out -> ping.tick", "ping.out -> pong.in", feedback,
                                                "ping.done -> sink.in"})}};
  Stretch stretch;
  RoundTrips measured(trips);
  run(use_case, spins, trips, stretch, measured);
  return measured;
}

double chain_stream_ns(int spins, int depth, int messages) {
  const Json edge = {{"from", "ticker.out"}, {"to", "sink.in"}, {"depth", depth}};
  const Json use_case = {{"name", "stream"},
                         {"links", {{"ticker", link("ticker", "A")}, {"sink", link("sink", "B")}}},
                         {"edges", Json::array({edge})}};
  return per_frame_ns(use_case, spins, messages);
}

double chain_line_ns(int links, int cores, int frames, int buffers) {
  constexpr int kSpins = 200;
  Json use_case = {{"name", "line"}, {"links", {{"ticker", link("ticker", "A")}}}, {"edges", Json::array()}};
  use_case["links"]["ticker"]["params"]["buffers"] = buffers;
  std::string last = "ticker";
  const auto append = [&](const std::string& type, const std::string& name, int at) {
    use_case["links"][name] = link(type, cores == 2 && at % 2 == 1 ? "B" : "A");
    use_case["edges"].push_back(last + ".out -> " + name + ".in");
    last = name;
  };
  for (int i = 1; i <= links; ++i) append("pass", "pass" + std::to_string(i), i);
  append("sink", "sink", links + 1);
  return per_frame_ns(use_case, kSpins, frames);
}

}  // namespace svchain::bench
