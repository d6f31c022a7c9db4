// Puts the faults of a run where they strike.

#include <algorithm>

#include "framework/chain/runtime.h"

namespace svchain {

namespace {

constexpr FaultKind kOfSources[] = {FaultKind::kFreeze, FaultKind::kJitter, FaultKind::kWrongTimestamp,
                                    FaultKind::kCorrupt};

/// Buffers for damaged copies of what the edge carries: as many as its own pictures have.
Pool* spare_pool(const Plan& plan, const std::vector<LinkSetup>& setups, int edge_index, Chain::Runtime& r) {
  const PlannedEdge& edge = plan.edges[static_cast<size_t>(edge_index)];
  const auto link = static_cast<size_t>(edge.from_link);
  const PortFormat& formats = setups[link].outputs[static_cast<size_t>(edge.from_port)];
  const bool equal =
      std::all_of(formats.begin(), formats.end(), [&](const Format& f) { return f == formats[0]; });
  if (!equal) return nullptr;
  const auto& core = r.cores[static_cast<size_t>(plan.links[link].core)];
  const size_t buffers = formats.size() * (1 + held_behind(plan, setups, edge_index));
  r.pools.push_back(std::make_unique<Pool>(static_cast<uint16_t>(r.pools.size()),
                                           edge.entry.from_link + "." + edge.entry.from_port + ".damaged",
                                           formats[0], buffers, plan.links.size(),
                                           PoolOwner{core->index(), &core->attention(), r.position[link]}));
  return r.pools.back().get();
}

}  // namespace

void build_spare_pools(const Plan& plan, const std::vector<LinkSetup>& setups, Chain::Runtime& r) {
  r.spare_pools.resize(plan.edges.size());
  for (size_t e = 0; e < plan.edges.size(); ++e) {
    if (r.faults->any(FaultKind::kCorrupt, e))
      r.spare_pools[e] = spare_pool(plan, setups, static_cast<int>(e), r);
  }
}

namespace {

std::unique_ptr<LinkFaults> faults_of(const Plan& plan, size_t l, const ChainOptions& options,
                                      Chain::Runtime& r) {
  const PlannedLink& link = plan.links[l];
  auto faults = std::make_unique<LinkFaults>(
      LinkFaults{r.faults->link(l), r.faults->core(static_cast<size_t>(link.core)), {}});
  faults->outputs.resize(link.output_edges.size());
  faults->takes_time = options.execution == Execution::kThreads;
  faults->gives_parts = link.input_edges.empty();
  const bool delivers = some_link_delivers(plan) ? link.description.delivers : link.output_edges.empty();
  if (delivers) faults->recovery = &r.faults->recovery();
  for (size_t port = 0; port < link.output_edges.size(); ++port) {
    const int edge_index = link.output_edges[port];
    if (edge_index < 0) continue;
    const auto e = static_cast<size_t>(edge_index);
    faults->gives_parts = faults->gives_parts && carries_parts(plan, plan.edges[e]);
    if (std::any_of(std::begin(kOfSources), std::end(kOfSources),
                    [&](FaultKind kind) { return r.faults->any(kind, e); }))
      faults->outputs[port].emplace(r.faults->edge(e), r.spare_pools[e], options.pace.pixels);
  }
  return faults;
}

}  // namespace

void build_faults(const Plan& plan, const ChainOptions& options, Chain::Runtime& r) {
  for (size_t c = 0; c < r.cores.size(); ++c) {
    std::vector<Edge*> departures;
    for (auto& edge : r.edges)
      if (edge->producer().core == static_cast<int>(c)) departures.push_back(edge.get());
    r.cores[c]->set_faults(r.faults->core(c), std::move(departures));
  }
  for (size_t e = 0; e < r.edges.size(); ++e) {
    const bool counted = plan.edges[e].on_main_way && !carries_parts(plan, plan.edges[e]);
    r.edges[e]->set_faults(r.faults->edge(e),
                           r.faults->core(static_cast<size_t>(r.edges[e]->producer().core)),
                           counted ? static_cast<uint16_t>(kEdgePlaces + e) : 0);
  }
  for (size_t l = 0; l < r.runners.size(); ++l) r.runners[l]->set_faults(faults_of(plan, l, options, r));
}

}  // namespace svchain
