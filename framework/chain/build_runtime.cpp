#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "framework/chain/runtime.h"

namespace svchain {

namespace {

using ipc::Doorbell;
using ipc::Ring;

}  // namespace

size_t held_behind(const Plan& plan, const std::vector<LinkSetup>& setups, int edge_index) {
  if (edge_index < 0) return 0;
  const PlannedEdge& edge = plan.edges[static_cast<size_t>(edge_index)];
  const PlannedLink& consumer = plan.links[static_cast<size_t>(edge.to_link)];
  const PortDescription& input = consumer.description.inputs[static_cast<size_t>(edge.to_port)];
  const int holds = setups[static_cast<size_t>(edge.to_link)].holds[static_cast<size_t>(edge.to_port)];
  const size_t in_call =
      input.intake == Intake::kState || edge.entry.feedback ? 2 : 1;  // the old one beside the new
  size_t count = static_cast<size_t>(edge.entry.depth + holds) + in_call;
  for (size_t port = 0; port < consumer.description.outputs.size(); ++port) {
    const auto& forwards = consumer.description.outputs[port].forwards;
    if (std::find(forwards.begin(), forwards.end(), input.name) == forwards.end()) continue;
    count += held_behind(plan, setups, consumer.output_edges[port]);
  }
  return count;
}

namespace {

void build_cores(const Plan& plan, Chain::Runtime& r) {
  const size_t count = plan.cores.size();
  constexpr size_t kSpacing = 2 * ipc::kCacheLine;  // no two doorbells in one pair of cache lines
  r.doorbells_region = ipc::SharedRegion("svchain:doorbells", std::max<size_t>(1, count) * kSpacing);
  std::vector<int> links_on(count);
  for (const PlannedLink& link : plan.links) ++links_on[static_cast<size_t>(link.core)];
  for (size_t c = 0; c < count; ++c) {
    r.doorbells.push_back(new (r.doorbells_region.bytes().data() + c * kSpacing) Doorbell);
    r.cores.push_back(std::make_unique<Core>(static_cast<int>(c), plan.cores[c].name, *r.doorbells[c],
                                             *r.clock, links_on[c]));
  }
  // Sink first: what is nearest to delivery runs first.
  r.position.resize(plan.links.size());
  std::vector<int> next(count);
  for (auto it = plan.source_to_sink.rbegin(); it != plan.source_to_sink.rend(); ++it) {
    const auto link = static_cast<size_t>(*it);
    r.position[link] = next[static_cast<size_t>(plan.links[link].core)]++;
  }
}

/// Own output ports of a link with equal formats share a pool.
std::vector<std::vector<std::vector<Pool*>>> build_pools(const Plan& plan,
                                                         const std::vector<LinkSetup>& setups,
                                                         Chain::Runtime& r) {
  std::vector<std::vector<std::vector<Pool*>>> by_link_port(plan.links.size());
  for (size_t l = 0; l < plan.links.size(); ++l) {
    const PlannedLink& link = plan.links[l];
    struct Need {
      Format format;
      size_t buffers = 0;
      std::string port;
      Pool* pool = nullptr;
    };
    std::vector<Need> needs;
    const auto need_of = [&](const Format& format) {
      return std::find_if(needs.begin(), needs.end(), [&](const Need& n) { return n.format == format; });
    };
    const auto& outputs = link.description.outputs;
    for (size_t port = 0; port < outputs.size(); ++port) {
      if (!outputs[port].forwards.empty()) continue;
      for (const Format& format : setups[l].outputs[port]) {
        auto need = need_of(format);
        if (need == needs.end()) need = needs.insert(needs.end(), {format, 0, outputs[port].name, nullptr});
        need->buffers += buffers_needed(plan, setups, static_cast<int>(l), static_cast<int>(port));
        const int edge = link.output_edges[port];
        if (r.faults && edge >= 0 && r.faults->any(FaultKind::kFreeze, static_cast<size_t>(edge)))
          ++need->buffers;  // the picture that it freezes at
      }
    }
    const auto& core = r.cores[static_cast<size_t>(link.core)];
    for (Need& need : needs) {
      const std::string name = needs.size() == 1 ? link.entry.name : link.entry.name + "." + need.port;
      r.pools.push_back(std::make_unique<Pool>(static_cast<uint16_t>(r.pools.size()), name, need.format,
                                               need.buffers, plan.links.size(),
                                               PoolOwner{link.core, &core->attention(), r.position[l]}));
      need.pool = r.pools.back().get();
    }
    by_link_port[l].resize(outputs.size());
    for (size_t port = 0; port < outputs.size(); ++port) {
      if (!outputs[port].forwards.empty()) continue;
      for (const Format& format : setups[l].outputs[port])
        by_link_port[l][port].push_back(need_of(format)->pool);
    }
  }
  return by_link_port;
}

/// A ring of returns from every core to every other that owns pools, long enough for all of the owner's
/// buffers.
void build_return_paths(Chain::Runtime& r) {
  const size_t cores = r.cores.size();
  std::vector<size_t> owned(cores);
  for (const auto& pool : r.pools) owned[static_cast<size_t>(pool->owner().core)] += pool->buffers();
  size_t bytes = 0;
  for (size_t count : owned) bytes += (cores - 1) * Ring<ReturnedBuffer>::bytes(count);
  r.returns_region = ipc::SharedRegion("svchain:returns", std::max<size_t>(1, bytes));
  std::byte* memory = r.returns_region.bytes().data();
  for (size_t core = 0; core < cores; ++core)
    r.return_paths.push_back(std::make_unique<ReturnPath>(static_cast<int>(core)));
  for (size_t from = 0; from < cores; ++from) {
    for (size_t to = 0; to < cores; ++to) {
      if (to == from || owned[to] == 0) continue;
      const auto ring = Ring<ReturnedBuffer>::create(memory, owned[to]);
      r.return_paths[from]->add_way(static_cast<int>(to), {ring, r.doorbells[to]});
      r.return_paths[to]->add_arrivals(ring);
      memory += Ring<ReturnedBuffer>::bytes(owned[to]);
    }
  }
}

std::optional<int64_t> modelled_latency_ns(const Plan& plan, const ChainOptions& options,
                                           const PlannedEdge& edge) {
  if (!options.costs) return std::nullopt;
  const auto core_of = [&](int link) {
    return plan.cores[static_cast<size_t>(plan.links[static_cast<size_t>(link)].core)];
  };
  if (!edge.ipc) return 0;
  const IpcCost& hop = options.costs->hop(core_of(edge.from_link).kind, core_of(edge.to_link).kind);
  return std::llround(hop.latency_us * 1e3);
}

Edge::End end_of(const Plan& plan, Chain::Runtime& r, int link) {
  const auto l = static_cast<size_t>(link);
  const auto core = static_cast<size_t>(plan.links[l].core);
  return {static_cast<int>(core), r.position[l], &r.cores[core]->attention(), r.doorbells[core],
          r.holders[l].get()};
}

/// An edge into a kState input: what it carries stays in force until the next.
bool carries_state(const Plan& plan, const PlannedEdge& edge) {
  const PlannedLink& consumer = plan.links[static_cast<size_t>(edge.to_link)];
  return consumer.description.inputs[static_cast<size_t>(edge.to_port)].intake == Intake::kState &&
         !edge.entry.feedback;
}

/// A recorder for every core, all of one size.
void build_recorders(const Plan& plan, size_t events, Chain::Runtime& r) {
  if (events == 0) return;
  for (size_t core = 0; core < r.cores.size(); ++core)
    r.recorders.push_back(std::make_unique<Recorder>(std::max<size_t>(1, events / r.cores.size())));
  for (size_t l = 0; l < plan.links.size(); ++l)
    r.runners[l]->set_recorder(static_cast<int>(l), *r.recorders[static_cast<size_t>(plan.links[l].core)]);
  for (size_t e = 0; e < r.edges.size(); ++e) {
    Edge& edge = *r.edges[e];
    edge.set_recorders(static_cast<int>(e), *r.recorders[static_cast<size_t>(edge.producer().core)],
                       *r.recorders[static_cast<size_t>(edge.consumer().core)]);
  }
}

}  // namespace

size_t buffers_needed(const Plan& plan, const std::vector<LinkSetup>& setups, int link, int port) {
  const int preloaded = setups[static_cast<size_t>(link)].preloaded[static_cast<size_t>(port)];
  if (preloaded > 0) return static_cast<size_t>(preloaded);
  const int edge = plan.links[static_cast<size_t>(link)].output_edges[static_cast<size_t>(port)];
  return 1 + held_behind(plan, setups, edge);
}

std::unique_ptr<Chain::Runtime> build_runtime(Plan& plan, const std::vector<LinkSetup>& setups,
                                              const ChainOptions& options, const Runner::Hooks& hooks) {
  auto runtime = std::make_unique<Chain::Runtime>();
  Chain::Runtime& r = *runtime;
  if (options.pace.virtual_clock) {
    auto clock = std::make_unique<VirtualClock>();
    r.virtual_clock = clock.get();
    r.clock = std::move(clock);
  } else {
    r.clock = std::make_unique<SteadyClock>();
  }
  build_cores(plan, r);
  if (options.faults) r.faults = std::make_unique<ChainFaults>(*options.faults, plan, options.pace.fps);
  const auto pools = build_pools(plan, setups, r);
  if (r.faults) build_spare_pools(plan, setups, r);
  build_return_paths(r);
  for (size_t l = 0; l < plan.links.size(); ++l) {
    r.holders.push_back(
        std::make_unique<Holder>(l, r.pools, *r.return_paths[static_cast<size_t>(plan.links[l].core)]));
  }
  for (const PlannedEdge& edge : plan.edges) {
    r.edges.push_back(std::make_unique<Edge>(edge.entry.name(), edge.entry.depth, edge.entry.policy,
                                             end_of(plan, r, edge.from_link), end_of(plan, r, edge.to_link),
                                             *r.clock, modelled_latency_ns(plan, options, edge)));
    Edge& built = *r.edges.back();
    if (built.ipc()) r.cores[static_cast<size_t>(built.consumer().core)]->add_arrivals(built);
  }
  for (size_t l = 0; l < plan.links.size(); ++l) {
    PlannedLink& link = plan.links[l];
    r.runners.push_back(
        std::make_unique<Runner>(link.entry.name, plan.cores[static_cast<size_t>(link.core)].name, link.link,
                                 link.description, link.entry.on_error, *r.holders[l], *r.clock, hooks));
    Runner& runner = *r.runners.back();
    runner.set_calls_without_room(setups[l].calls_without_room);
    if (link.on_main_way) runner.set_place(static_cast<uint16_t>(l + 1));
    for (size_t port = 0; port < link.input_edges.size(); ++port) {
      const int e = link.input_edges[port];
      if (e < 0) continue;
      runner.connect_input(static_cast<int>(port), *r.edges[static_cast<size_t>(e)],
                           plan.edges[static_cast<size_t>(e)].entry.feedback, !options.pace.real_time);
    }
    for (size_t port = 0; port < link.output_edges.size(); ++port) {
      const int e = link.output_edges[port];
      runner.connect_output(static_cast<int>(port), e < 0 ? nullptr : r.edges[static_cast<size_t>(e)].get(),
                            pools[l][port], setups[l].preloaded[port] > 0);
      if (e >= 0 && carries_state(plan, plan.edges[static_cast<size_t>(e)]))
        runner.keep_newest(static_cast<int>(port));
    }
  }
  for (auto it = plan.source_to_sink.rbegin(); it != plan.source_to_sink.rend(); ++it) {
    const auto l = static_cast<size_t>(*it);
    r.cores[static_cast<size_t>(plan.links[l].core)]->add(*r.runners[l]);
  }
  build_recorders(plan, options.trace_events, r);
  if (r.faults) build_faults(plan, options, r);
  if (options.costs) r.modelled = std::make_unique<ModelledTime>(plan, *options.costs, r);
  return runtime;
}

}  // namespace svchain
