// Do both ends of every edge speak of the same thing? Only types and counts are known before the links are
// configured; an output that forwards and leaves them open carries what its input gets.

#include <algorithm>

#include "framework/usecase/plan_steps.h"

namespace svchain {

namespace {

/// What may pass a port. No types: any; count 0: any.
struct Carried {
  std::vector<std::string> types;
  int count = 0;
};

Carried carried(const PortDescription& port) {
  return {port.types, port.count};
}

std::vector<std::string> common(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  std::vector<std::string> both;
  std::copy_if(a.begin(), a.end(), std::back_inserter(both),
               [&](const auto& type) { return std::find(b.begin(), b.end(), type) != b.end(); });
  return both;
}

class FormatCheck {
 public:
  FormatCheck(const Plan& plan, Faults& faults) : plan_(plan), faults_(faults), offered_(plan.edges.size()) {}

  void run() {
    for (int link : plan_.source_to_sink) offer(plan_.links[static_cast<size_t>(link)]);
    for (size_t e = 0; e < plan_.edges.size(); ++e) {
      if (complete(plan_.edges[e])) compare(plan_.edges[e], offered_[e]);
    }
  }

 private:
  void offer(const PlannedLink& link) {
    for (size_t port = 0; port < link.output_edges.size(); ++port) {
      if (link.output_edges[port] == -1) continue;
      offered_[static_cast<size_t>(link.output_edges[port])] = output(link, link.description.outputs[port]);
    }
  }

  Carried output(const PlannedLink& link, const PortDescription& port) const {
    Carried out = carried(port);
    std::vector<std::string> forwarded;
    bool any = port.forwards.empty();
    for (const std::string& name : port.forwards) {
      const Carried in = input(link, name);
      any = any || in.types.empty();
      forwarded.insert(forwarded.end(), in.types.begin(), in.types.end());
      if (out.count == 0 && port.forwards.size() == 1) out.count = in.count;
    }
    std::sort(forwarded.begin(), forwarded.end());
    forwarded.erase(std::unique(forwarded.begin(), forwarded.end()), forwarded.end());
    if (out.types.empty() && !any) out.types = forwarded;
    return out;
  }

  Carried input(const PlannedLink& link, const std::string& name) const {
    const PortDescription* port = link.description.input(name);
    if (!port) return {};
    Carried in = carried(*port);
    const int edge = link.input_edges[static_cast<size_t>(port - link.description.inputs.data())];
    if (edge == -1) return in;
    const Carried& offered = offered_[static_cast<size_t>(edge)];
    in.types = common(offered.types, in.types);
    if (in.count == 0) in.count = offered.count;
    return in;
  }

  void compare(const PlannedEdge& edge, const Carried& gives) {
    const Carried takes = carried(
        plan_.links[static_cast<size_t>(edge.to_link)].description.inputs[static_cast<size_t>(edge.to_port)]);
    if (!gives.types.empty() && !takes.types.empty() && common(gives.types, takes.types).empty()) {
      differ(edge, "type", spoken_list(gives.types), spoken_list(takes.types));
    }
    if (gives.count != 0 && takes.count != 0 && gives.count != takes.count) {
      differ(edge, "buffers", std::to_string(gives.count), std::to_string(takes.count));
    }
  }

  void differ(const PlannedEdge& edge, const std::string& field, const std::string& gives,
              const std::string& takes) {
    const EdgeEntry& e = edge.entry;
    faults_.push_back(e.origin.fault("formats differ: \"" + e.from_link + "." + e.from_port + "\" gives " +
                                     field + " " + gives + ", \"" + e.to_link + "." + e.to_port +
                                     "\" takes " + field + " " + takes));
  }

  const Plan& plan_;
  Faults& faults_;
  std::vector<Carried> offered_;  // by edge
};

}  // namespace

void check_formats(const Plan& plan, Faults& faults) {
  FormatCheck(plan, faults).run();
}

}  // namespace svchain
