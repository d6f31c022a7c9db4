#include "framework/usecase/graph.h"

namespace svchain {

namespace {

void add_pair(const Plan& plan, const PlannedEdge& edge, Graph& graph) {
  const EdgeEntry& e = edge.entry;
  const PlannedLink& from = plan.links[static_cast<size_t>(edge.from_link)];
  const PlannedLink& to = plan.links[static_cast<size_t>(edge.to_link)];
  const std::string out = e.from_link + "." + e.from_port + ".ipc_out";
  const std::string in = e.to_link + "." + e.to_port + ".ipc_in";
  graph.nodes.push_back({out, "ipc_out", from.core, from.rank, edge.on_main_way, true});
  graph.nodes.push_back({in, "ipc_in", to.core, to.rank, edge.on_main_way, true});
  graph.edges.push_back({e.from_link, e.from_port, out, "in", &edge, false});
  graph.edges.push_back({out, "out", in, "in", &edge, true});
  graph.edges.push_back({in, "out", e.to_link, e.to_port, &edge, false});
}

}  // namespace

Graph graph_of(const Plan& plan) {
  Graph graph;
  for (const PlannedLink& link : plan.links) {
    graph.nodes.push_back({link.entry.name, link.entry.type, link.core, link.rank, link.on_main_way, false});
  }
  for (const PlannedEdge& edge : plan.edges) {
    if (edge.ipc) {
      add_pair(plan, edge, graph);
    } else {
      const EdgeEntry& e = edge.entry;
      graph.edges.push_back({e.from_link, e.from_port, e.to_link, e.to_port, &edge, false});
    }
  }
  return graph;
}

}  // namespace svchain
