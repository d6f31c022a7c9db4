#pragma once
// The planner: checks that a use case makes a graph that can run on a SoC, resolves roles to cores, orders
// the links, finds the edges that cross cores (each becomes an IPC pair) and the way of the frames to what
// delivers them. A plan owns its links, described but not yet configured. One thread.

#include <memory>
#include <string>
#include <vector>

#include "framework/usecase/soc.h"
#include "framework/usecase/use_case.h"

namespace svchain {

struct PlannedLink {
  LinkEntry entry;
  std::unique_ptr<Link> link;
  LinkDescription description;
  int core = 0;                   // index into Plan::cores
  int rank = 0;                   // longest way from a source, feedback edges left out
  bool on_main_way = false;       // frames pass here on their way to a link that delivers
  std::vector<int> input_edges;   // by input port: index into Plan::edges, -1: unconnected
  std::vector<int> output_edges;  // by output port
};

struct PlannedEdge {
  EdgeEntry entry;
  int from_link = 0, from_port = 0, to_link = 0, to_port = 0;
  bool ipc = false;
  bool on_main_way = false;
};

struct Plan {
  UseCase use_case;
  Soc soc;
  std::vector<SocCore> cores;       // those in use, in the SoC's order
  std::vector<PlannedLink> links;   // in the use case's order
  std::vector<PlannedEdge> edges;   // in the use case's order
  std::vector<int> source_to_sink;  // link indices by rank
};

Result<Plan> make_plan(UseCase use_case, Soc soc, const Catalogue& catalogue);
/// What the planner finds in a use case that was read with faults, what follows from those left out.
Faults plan_faults(UseCase use_case, Soc soc, const Catalogue& catalogue);

/// Pictures of a plan, one colour per core, IPC edges marked with their ipc_out / ipc_in pair.
std::string graph_dot(const Plan& plan);
std::string graph_svg(const Plan& plan);
std::string graph_json(const Plan& plan);

}  // namespace svchain
