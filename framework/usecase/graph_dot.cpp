#include <sstream>

#include "framework/usecase/graph.h"
#include "framework/usecase/palette.h"

namespace svchain {

namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

void write_node(const GraphNode& node, std::ostream& out) {
  const Colour& colour = colour_of_core(node.core);
  out << "    " << quoted(node.id);
  if (node.is_ipc) {
    out << " [label=" << quoted(node.type == "ipc_out" ? "IPC out" : "IPC in")
        << ", fontsize=9, height=0.25, fillcolor=white, color=" << quoted(colour.edge) << "];\n";
    return;
  }
  const std::string type = node.type == node.id ? "" : "\\n(" + node.type + ")";
  const std::string label = quoted(node.id);
  out << " [label=" << label.substr(0, label.size() - 1) << type << "\", fillcolor=" << quoted(colour.box)
      << ", color=" << quoted(colour.edge) << "];\n";
}

void write_edge(const GraphEdge& edge, std::ostream& out) {
  out << "  " << quoted(edge.from) << " -> " << quoted(edge.to) << " [";
  const bool from_link = !edge.crosses && edge.from == edge.edge->entry.from_link;
  const bool to_link = !edge.crosses && edge.to == edge.edge->entry.to_link;
  if (from_link) out << "taillabel=" << quoted(edge.from_port) << ", ";
  if (to_link) out << "headlabel=" << quoted(edge.to_port) << ", ";
  if (edge.crosses) out << "penwidth=2.4, ";
  if (edge.edge->entry.feedback) out << "style=dashed, color=\"#c0392b\", constraint=false, ";
  out << "tooltip=" << quoted(edge.edge->entry.name()) << "];\n";
}

}  // namespace

std::string graph_dot(const Plan& plan) {
  const Graph graph = graph_of(plan);
  std::ostringstream out;
  out << "digraph " << quoted(plan.use_case.name) << " {\n"
      << "  rankdir=LR; labelloc=t; fontname=\"Helvetica\"; label="
      << quoted(plan.use_case.name + " on " + plan.soc.title)
      << ";\n  node [shape=box, style=\"rounded,filled\", fontname=\"Helvetica\", fontsize=11];\n"
      << "  edge [fontname=\"Helvetica\", fontsize=9, color=\"#555555\"];\n";
  for (size_t core = 0; core < plan.cores.size(); ++core) {
    const int index = static_cast<int>(core);
    out << "  subgraph " << quoted("cluster_" + plan.cores[core].name)
        << " {\n    label=" << quoted(plan.cores[core].name)
        << "; style=\"rounded,filled\"; color=" << quoted(colour_of_core(index).lane) << ";\n";
    for (const GraphNode& node : graph.nodes) {
      if (node.core == index) write_node(node, out);
    }
    out << "  }\n";
  }
  for (const GraphEdge& edge : graph.edges) write_edge(edge, out);
  out << "}\n";
  return out.str();
}

}  // namespace svchain
