#include "framework/fault/fault_plan.h"

#include <algorithm>
#include <cmath>

#include "framework/fault/fault_places.h"
#include "framework/fault/random_faults.h"

namespace svchain {

namespace {

bool is_called(const FaultPlace& place, const std::string& name) {
  const auto& others = place.other_names;
  return place.name == name || std::find(others.begin(), others.end(), name) != others.end();
}

Fault unknown_place(const FaultEntry& entry, const std::vector<FaultPlace>& places) {
  std::vector<std::string> names, known;
  for (const FaultPlace& place : places) {
    known.push_back(place.name);
    names.push_back(place.name);
    names.insert(names.end(), place.other_names.begin(), place.other_names.end());
  }
  return entry.origin.fault(std::string("a fault \"") + name_of(entry.kind) + "\" needs " +
                            kind_of_place(entry.kind) + ", got \"" + entry.at + "\"" +
                            did_you_mean(entry.at, names) +
                            (known.empty() ? " (there is none)" : " (known: " + spoken_list(known) + ")"));
}

PlannedFault planned(const FaultEntry& entry, const FaultPlace& place) {
  PlannedFault fault;
  fault.kind = entry.kind;
  fault.place = place.index;
  fault.at = place.name;
  fault.from_ns = std::llround(entry.from_s * 1e9);
  fault.to_ns = std::isinf(entry.to_s) ? PlannedFault::kNever : std::llround(entry.to_s * 1e9);
  fault.chance = entry.chance;
  fault.amount_ns = std::llround(entry.amount_ms * 1e6);
  fault.factor = entry.factor;
  return fault;
}

}  // namespace

Result<FaultPlan> place_faults(const FaultScript& script, const Plan& plan, uint64_t seed) {
  FaultPlan result;
  result.seed = seed;
  Faults unknown;
  for (const FaultEntry& entry : script.entries) {
    const auto places = places_of(entry.kind, plan);
    const bool clock = entry.kind == FaultKind::kClockStep;
    const auto place = std::find_if(places.begin(), places.end(),
                                    [&](const auto& it) { return clock || is_called(it, entry.at); });
    if (place == places.end()) {
      unknown.push_back(unknown_place(entry, places));
    } else {
      result.faults.push_back(planned(entry, *place));
    }
  }
  if (script.random) {
    const auto drawn = draw_faults(*script.random, plan, seed);
    if (drawn) {
      result.faults.insert(result.faults.end(), drawn->begin(), drawn->end());
    } else {
      unknown.push_back(drawn.error().front());
    }
  }
  if (!unknown.empty()) return tl::unexpected(std::move(unknown));
  std::stable_sort(result.faults.begin(), result.faults.end(),
                   [](const auto& a, const auto& b) { return a.from_ns < b.from_ns; });
  return result;
}

}  // namespace svchain
