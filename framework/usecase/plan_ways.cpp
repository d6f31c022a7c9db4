// Where frames come from and where they go.

#include <algorithm>

#include "framework/usecase/plan_steps.h"

namespace svchain {

namespace {

bool is_source(const PlannedLink& link) {
  return link.link && link.description.inputs.empty();
}
bool is_sink(const PlannedLink& link) {
  return link.link && link.description.outputs.empty();
}

/// Adds every link that an edge leads to from those in the set.
void spread(const Plan& plan, std::vector<bool>& reached) {
  std::vector<int> open;
  for (size_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) open.push_back(static_cast<int>(i));
  }
  while (!open.empty()) {
    const int link = open.back();
    open.pop_back();
    for (const PlannedEdge& edge : plan.edges) {
      const auto to = static_cast<size_t>(edge.to_link);
      if (edge.from_link != link || reached[to]) continue;
      reached[to] = true;
      open.push_back(edge.to_link);
    }
  }
}

bool lacks_input(const PlannedLink& link) {
  for (size_t port = 0; port < link.input_edges.size(); ++port) {
    if (link.input_edges[port] == -1 && !link.description.inputs[port].optional) return true;
  }
  return false;
}

std::string names_of(const Plan& plan, bool (*test)(const PlannedLink&)) {
  std::vector<std::string> names;
  for (const auto& link : plan.links) {
    if (test(link)) names.push_back(link.entry.name);
  }
  return spoken_list(names);
}

/// One fault for each group of links that no frame reaches, at its first link. Links behind one that lacks an
/// input, or whose type is unknown, have their fault already.
void check_reached(const Plan& plan, Faults& faults) {
  std::vector<bool> reached(plan.links.size(), false);
  for (size_t i = 0; i < plan.links.size(); ++i) {
    const PlannedLink& link = plan.links[i];
    reached[i] = is_source(link) || !link.link || lacks_input(link);
  }
  spread(plan, reached);
  for (int i : plan.source_to_sink) {
    if (reached[static_cast<size_t>(i)]) continue;
    const PlannedLink& link = plan.links[static_cast<size_t>(i)];
    faults.push_back(link.entry.origin.fault("no frame ever reaches \"" + link.entry.name +
                                             "\": no edges lead here from a source (" +
                                             names_of(plan, is_source) + ")"));
    reached[static_cast<size_t>(i)] = true;
    spread(plan, reached);
  }
}

}  // namespace

void check_ways(const Plan& plan, Faults& faults) {
  const auto unknown = [](const PlannedLink& link) { return !link.link; };
  if (std::any_of(plan.links.begin(), plan.links.end(), unknown)) return;  // it may be just what is missing
  const bool source = std::any_of(plan.links.begin(), plan.links.end(), is_source);
  const bool sink = std::any_of(plan.links.begin(), plan.links.end(), is_sink);
  if (!source) {
    faults.push_back(plan.use_case.links_origin.fault(
        "no source: expected at least one link without inputs, such as capture"));
  }
  if (!sink) {
    faults.push_back(plan.use_case.links_origin.fault(
        "no sink: expected at least one link without outputs, such as display or null"));
  }
  if (source) check_reached(plan, faults);
}

void mark_main_way(Plan& plan) {
  const bool delivers = std::any_of(plan.links.begin(), plan.links.end(),
                                    [](const PlannedLink& link) { return link.description.delivers; });
  for (PlannedLink& link : plan.links)
    link.on_main_way = delivers ? link.description.delivers : is_sink(link);
  // From sink to source, every link is marked before those that feed it are looked at.
  for (auto i = plan.source_to_sink.rbegin(); i != plan.source_to_sink.rend(); ++i) {
    const PlannedLink& link = plan.links[static_cast<size_t>(*i)];
    if (!link.on_main_way) continue;
    for (size_t port = 0; port < link.input_edges.size(); ++port) {
      if (link.input_edges[port] == -1 || link.description.inputs[port].intake != Intake::kEach) continue;
      PlannedEdge& edge = plan.edges[static_cast<size_t>(link.input_edges[port])];
      if (edge.entry.feedback) continue;
      edge.on_main_way = true;
      plan.links[static_cast<size_t>(edge.from_link)].on_main_way = true;
    }
  }
}

}  // namespace svchain
