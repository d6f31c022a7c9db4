#pragma once
// The steps of the planner, in the order they are taken. Internal to plan.cpp. Each records every fault it
// finds; an edge whose port is unknown keeps the port -1 and is left out of what it cannot take part in.

#include <string>

#include "framework/usecase/plan.h"

namespace svchain {

constexpr int kNoPort = -1;

inline bool complete(const PlannedEdge& edge) {
  return edge.from_port != kNoPort && edge.to_port != kNoPort;
}

/// Ranks and source_to_sink; cycles without feedback, feedback without a cycle.
void order_links(Plan& plan, Faults& faults);
/// Both ends of every edge agree on types and counts, through outputs that forward (links in order).
void check_formats(const Plan& plan, Faults& faults);
/// There is a source and a sink, and frames reach every link (links in order).
void check_ways(const Plan& plan, Faults& faults);
void mark_main_way(Plan& plan);

}  // namespace svchain
