#include "framework/fault/fault_places.h"

#include <algorithm>

namespace svchain {

namespace {

bool is_source(const PlannedLink& link) {
  return link.description.inputs.empty();
}

bool has_pool(const PlannedLink& link) {
  const auto& outputs = link.description.outputs;
  return std::any_of(outputs.begin(), outputs.end(), [](const auto& port) { return port.forwards.empty(); });
}

template <class Accept>
std::vector<FaultPlace> links_of(const Plan& plan, Accept accept) {
  std::vector<FaultPlace> places;
  for (size_t l = 0; l < plan.links.size(); ++l) {
    if (accept(plan.links[l])) places.push_back({static_cast<int>(l), plan.links[l].entry.name, {}});
  }
  return places;
}

std::string output_of(const EdgeEntry& edge) {
  return edge.from_link + "." + edge.from_port;
}

std::vector<FaultPlace> edges_of(const Plan& plan) {
  std::vector<FaultPlace> places;
  for (size_t e = 0; e < plan.edges.size(); ++e) {
    const EdgeEntry& edge = plan.edges[e].entry;
    places.push_back({static_cast<int>(e), edge.name(), {output_of(edge)}});
  }
  return places;
}

std::vector<FaultPlace> source_outputs_of(const Plan& plan) {
  std::vector<FaultPlace> places;
  for (size_t e = 0; e < plan.edges.size(); ++e) {
    const PlannedEdge& edge = plan.edges[e];
    if (!is_source(plan.links[static_cast<size_t>(edge.from_link)])) continue;
    places.push_back({static_cast<int>(e), output_of(edge.entry), {edge.entry.name()}});
  }
  return places;
}

std::vector<FaultPlace> cores_of(const Plan& plan) {
  std::vector<FaultPlace> places;
  for (size_t c = 0; c < plan.cores.size(); ++c) {
    FaultPlace place{static_cast<int>(c), plan.cores[c].name, {}};
    for (const auto& [role, core] : plan.soc.roles) {
      if (core == place.name) place.other_names.push_back(role);
    }
    places.push_back(std::move(place));
  }
  return places;
}

}  // namespace

std::vector<FaultPlace> places_of(FaultKind kind, const Plan& plan) {
  switch (kind) {
    case FaultKind::kDropout:
    case FaultKind::kFreeze:
    case FaultKind::kJitter:
    case FaultKind::kWrongTimestamp:
    case FaultKind::kCorrupt:
      return source_outputs_of(plan);
    case FaultKind::kSlow:
    case FaultKind::kThrow:
      return links_of(plan, [](const PlannedLink&) { return true; });
    case FaultKind::kNoMemory:
      return links_of(plan, has_pool);
    case FaultKind::kLost:
    case FaultKind::kLate:
    case FaultKind::kFull:
      return edges_of(plan);
    case FaultKind::kHalt:
      return cores_of(plan);
    case FaultKind::kClockStep:
      return {{-1, "clock", {}}};
  }
  return {};
}

const char* kind_of_place(FaultKind kind) {
  switch (kind) {
    case FaultKind::kSlow:
    case FaultKind::kThrow:
      return "a link";
    case FaultKind::kNoMemory:
      return "a link with buffers of its own";
    case FaultKind::kLost:
    case FaultKind::kLate:
    case FaultKind::kFull:
      return "an edge";
    case FaultKind::kHalt:
      return "a core in use";
    case FaultKind::kClockStep:
      return "the clock";
    default:
      return "an output of a source";
  }
}

}  // namespace svchain
