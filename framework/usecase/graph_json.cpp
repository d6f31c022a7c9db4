#include <nlohmann/json.hpp>

#include "framework/usecase/entries.h"
#include "framework/usecase/graph.h"

namespace svchain {

std::string graph_json(const Plan& plan) {
  using Json = nlohmann::ordered_json;
  const Graph graph = graph_of(plan);
  Json root = {{"usecase", plan.use_case.name}, {"soc", plan.soc.name}};
  root["cores"] = Json::array();
  for (const SocCore& core : plan.cores) {
    root["cores"].push_back({{"name", core.name}, {"kind", core.kind}, {"clock_mhz", core.clock_mhz}});
  }
  root["nodes"] = Json::array();
  for (const GraphNode& node : graph.nodes) {
    root["nodes"].push_back({{"id", node.id},
                             {"type", node.type},
                             {"core", plan.cores[static_cast<size_t>(node.core)].name},
                             {"rank", node.rank},
                             {"on_main_way", node.on_main_way}});
  }
  root["edges"] = Json::array();
  for (const GraphEdge& edge : graph.edges) {
    const EdgeEntry& entry = edge.edge->entry;
    root["edges"].push_back({{"name", entry.name()},
                             {"from", edge.from},
                             {"from_port", edge.from_port},
                             {"to", edge.to},
                             {"to_port", edge.to_port},
                             {"ipc", edge.crosses},
                             {"feedback", entry.feedback},
                             {"depth", entry.depth},
                             {"policy", kPolicyNames[static_cast<size_t>(entry.policy)]},
                             {"on_main_way", edge.edge->on_main_way}});
  }
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace svchain
