#include "framework/usecase/plan.h"

#include <algorithm>

#include "framework/usecase/plan_steps.h"

namespace svchain {

namespace {

std::vector<std::string> port_names(const std::vector<PortDescription>& ports) {
  std::vector<std::string> names;
  for (const auto& port : ports) names.push_back(port.name);
  return names;
}

int index_of(const std::vector<std::string>& names, const std::string& name) {
  const auto it = std::find(names.begin(), names.end(), name);
  return it == names.end() ? kNoPort : static_cast<int>(it - names.begin());
}

void take_links(Plan& plan, const Catalogue& catalogue) {
  for (const LinkEntry& entry : plan.use_case.links) {
    PlannedLink planned;
    planned.entry = entry;
    planned.link = catalogue.make(entry.type);
    if (planned.link) planned.description = planned.link->describe();
    planned.input_edges.assign(planned.description.inputs.size(), -1);
    planned.output_edges.assign(planned.description.outputs.size(), -1);
    plan.links.push_back(std::move(planned));
  }
}

std::string no_such_core(const std::string& core, const Soc& soc) {
  std::vector<std::string> names = soc.core_names();
  for (const auto& [role, name] : soc.roles) names.push_back(role);
  return "\"" + soc.name + "\" has no core \"" + core + "\"" + did_you_mean(core, names) + " (it has " +
         spoken_list(names) + ")";
}

/// Later ones, which are the command line's, over earlier ones.
void set_cpus(Plan& plan, Faults& faults) {
  for (const CpusEntry& entry : plan.use_case.cpus) {
    const SocCore* core = plan.soc.find(entry.core);
    if (core) {
      plan.soc.cores[static_cast<size_t>(core - plan.soc.cores.data())].cpus = entry.cpus;
    } else {
      faults.push_back(entry.origin.fault(no_such_core(entry.core, plan.soc)));
    }
  }
}

void place_links(Plan& plan, Faults& faults) {
  std::vector<const SocCore*> places;
  for (const PlannedLink& planned : plan.links) {
    const SocCore* core = plan.soc.find(planned.entry.core);
    if (!core && !planned.entry.core.empty())
      faults.push_back(planned.entry.core_origin.fault(no_such_core(planned.entry.core, plan.soc)));
    places.push_back(core);
  }
  for (const SocCore& core : plan.soc.cores) {
    const int index = static_cast<int>(plan.cores.size());
    bool used = false;
    for (size_t i = 0; i < places.size(); ++i) {
      if (places[i] != &core) continue;
      plan.links[i].core = index;
      used = true;
    }
    if (used) plan.cores.push_back(core);
  }
}

/// The port's index; a fault where there is none, saying what there is.
int find_port(const PlannedLink& link, const std::string& port, bool is_output, const Origin& origin,
              Faults& faults) {
  const auto wanted = port_names(is_output ? link.description.outputs : link.description.inputs);
  const auto others = port_names(is_output ? link.description.inputs : link.description.outputs);
  const int index = index_of(wanted, port);
  if (index != kNoPort || !link.link) return index;
  const std::string kind = is_output ? "output" : "input";
  const std::string name = "\"" + link.entry.name + "." + port + "\"";
  std::string what = index_of(others, port) == kNoPort
                         ? name + " is no " + kind + did_you_mean(port, wanted)
                         : name + " is an " + (is_output ? "input" : "output") + ", expected an " + kind;
  what += wanted.empty() ? "; \"" + link.entry.name + "\" has no " + kind + "s"
                         : " (" + kind + "s: " + spoken_list(wanted) + ")";
  faults.push_back(origin.fault(what));
  return kNoPort;
}

void connect(Plan& plan, int index, Faults& faults) {
  PlannedEdge& edge = plan.edges[static_cast<size_t>(index)];
  const auto claim = [&](std::vector<int>& ports, int port, const std::string& what) {
    if (port == kNoPort) return;
    int& slot = ports[static_cast<size_t>(port)];
    if (slot == -1) {
      slot = index;
    } else {
      faults.push_back(edge.entry.origin.fault(what + ", already taken by \"" +
                                               plan.edges[static_cast<size_t>(slot)].entry.name() + "\""));
    }
  };
  const EdgeEntry& e = edge.entry;
  claim(plan.links[static_cast<size_t>(edge.from_link)].output_edges, edge.from_port,
        "the output \"" + e.from_link + "." + e.from_port + "\" feeds one edge only: use a dup link");
  claim(plan.links[static_cast<size_t>(edge.to_link)].input_edges, edge.to_port,
        "the input \"" + e.to_link + "." + e.to_port + "\" takes one edge only");
}

void take_edges(Plan& plan, Faults& faults) {
  std::vector<std::string> names;
  for (const auto& link : plan.links) names.push_back(link.entry.name);
  for (const EdgeEntry& entry : plan.use_case.edges) {
    PlannedEdge edge;
    edge.entry = entry;
    edge.from_link = index_of(names, entry.from_link);
    edge.to_link = index_of(names, entry.to_link);
    if (edge.from_link < 0 || edge.to_link < 0) continue;
    const PlannedLink& from = plan.links[static_cast<size_t>(edge.from_link)];
    const PlannedLink& to = plan.links[static_cast<size_t>(edge.to_link)];
    edge.from_port = find_port(from, entry.from_port, true, entry.origin, faults);
    edge.to_port = find_port(to, entry.to_port, false, entry.origin, faults);
    edge.ipc = from.core != to.core;
    plan.edges.push_back(std::move(edge));
    connect(plan, static_cast<int>(plan.edges.size()) - 1, faults);
  }
}

/// Inputs that nothing feeds. A link that an edge misses by a wrong port name has its fault already.
void check_inputs(const Plan& plan, Faults& faults) {
  for (size_t l = 0; l < plan.links.size(); ++l) {
    const PlannedLink& link = plan.links[l];
    const bool missed = std::any_of(plan.edges.begin(), plan.edges.end(), [&](const PlannedEdge& edge) {
      return edge.to_link == static_cast<int>(l) && edge.to_port == kNoPort;
    });
    for (size_t port = 0; port < link.input_edges.size(); ++port) {
      const PortDescription& input = link.description.inputs[port];
      if (missed || input.optional || link.input_edges[port] != -1) continue;
      faults.push_back(link.entry.origin.fault("no edge leads to the input \"" + link.entry.name + "." +
                                               input.name + "\", which is required"));
    }
  }
}

/// Links on their cores, joined by their edges: what can be done with a use case that was read with faults,
/// too.
Plan lay_out(UseCase use_case, Soc soc, const Catalogue& catalogue, Faults& faults) {
  Plan plan;
  plan.use_case = std::move(use_case);
  plan.soc = std::move(soc);
  take_links(plan, catalogue);
  set_cpus(plan, faults);
  place_links(plan, faults);
  take_edges(plan, faults);
  return plan;
}

}  // namespace

Result<Plan> make_plan(UseCase use_case, Soc soc, const Catalogue& catalogue) {
  Faults faults;
  Plan plan = lay_out(std::move(use_case), std::move(soc), catalogue, faults);
  check_inputs(plan, faults);
  order_links(plan, faults);
  check_formats(plan, faults);
  check_ways(plan, faults);
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  mark_main_way(plan);
  return plan;
}

Faults plan_faults(UseCase use_case, Soc soc, const Catalogue& catalogue) {
  Faults faults;
  lay_out(std::move(use_case), std::move(soc), catalogue, faults);
  return faults;
}

}  // namespace svchain
