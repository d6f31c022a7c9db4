#pragma once
// A plan as it runs: its links and, where an edge crosses cores, the ipc_out / ipc_in pair that was put in.
// Internal to the pictures of a plan.

#include <string>
#include <vector>

#include "framework/usecase/plan.h"

namespace svchain {

struct GraphNode {
  std::string id;    // "synthesis", "synthesis.view.ipc_out"
  std::string type;  // "synthesis", "ipc_out", "ipc_in"
  int core = 0;
  int rank = 0;  // of the link, or of the link that an IPC end belongs to
  bool on_main_way = false;
  bool is_ipc = false;
};

struct GraphEdge {
  std::string from, from_port, to, to_port;  // ids and ports; IPC ends have "out" and "in"
  const PlannedEdge* edge = nullptr;         // of the use case
  bool crosses = false;                      // from an ipc_out to its ipc_in
};

struct Graph {
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
};

/// Borrows the plan.
Graph graph_of(const Plan& plan);

}  // namespace svchain
