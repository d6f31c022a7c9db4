#include "framework/fault/chain_faults.h"

#include <nlohmann/json.hpp>

namespace svchain {

namespace {

bool is_of_a_link(FaultKind kind) {
  return kind == FaultKind::kSlow || kind == FaultKind::kThrow || kind == FaultKind::kNoMemory;
}

}  // namespace

ChainFaults::ChainFaults(FaultPlan plan, const Plan& chain, double fps)
    : plan_(std::move(plan)),
      links_(chain.links.size()),
      edges_(chain.edges.size()),
      recovery_(plan_.faults, fps) {
  for (size_t c = 0; c < chain.cores.size(); ++c) cores_.push_back(std::make_unique<CoreFaults>());
  for (auto* sites : {&links_, &edges_})
    for (FaultSite& site : *sites) site.reserve(plan_.faults.size());
  for (auto& core : cores_) core->core().reserve(plan_.faults.size());

  for (const PlannedFault& fault : plan_.faults) {
    const auto place = static_cast<size_t>(fault.place);
    if (fault.kind == FaultKind::kClockStep) {
      for (size_t c = 0; c < cores_.size(); ++c) add(fault, cores_[c]->core(), static_cast<int>(c));
    } else if (fault.kind == FaultKind::kHalt) {
      add(fault, cores_[place]->core(), fault.place);
    } else if (is_of_a_link(fault.kind)) {
      add(fault, links_[place], chain.links[place].core);
    } else {
      const int from_link = chain.edges[place].from_link;
      add(fault, edges_[place], chain.links[static_cast<size_t>(from_link)].core);
    }
  }
}

void ChainFaults::add(const PlannedFault& fault, FaultSite& site, int core) {
  injected_.push_back(std::make_unique<InjectedFault>());
  InjectedFault& injected = *injected_.back();
  injected.planned = &fault;
  const auto number = static_cast<uint64_t>(&fault - plan_.faults.data());
  injected.seed = plan_.seed * 0x9e3779b97f4a7c15u + number;
  cores_[static_cast<size_t>(core)]->add(injected, site);
}

bool ChainFaults::any(FaultKind kind, size_t edge) const {
  return std::any_of(plan_.faults.begin(), plan_.faults.end(), [&](const PlannedFault& fault) {
    return fault.kind == kind && fault.place == static_cast<int>(edge);
  });
}

void ChainFaults::start(int64_t now_ns) {
  for (auto& core : cores_) core->start(now_ns);
  recovery_.start(now_ns);
}

nlohmann::json ChainFaults::report() const {
  const auto seconds = [](int64_t ns) { return static_cast<double>(ns / 1000) / 1e6; };
  nlohmann::json report = {{"seed", plan_.seed}, {"recovery", recovery_.report()}};
  nlohmann::json& list = report["list"] = nlohmann::json::array();
  for (const PlannedFault& fault : plan_.faults) {
    nlohmann::json entry = {{"kind", name_of(fault.kind)}, {"from_s", seconds(fault.from_ns)}};
    if (!fault.at.empty()) entry["at"] = fault.at;
    if (fault.to_ns < PlannedFault::kNever) entry["to_s"] = seconds(fault.to_ns);
    uint64_t times = 0;
    for (const auto& injected : injected_) {  // a clock steps on all cores at once
      if (injected->planned == &fault) times = std::max(times, injected->times.value());
    }
    entry["times"] = times;
    list.push_back(std::move(entry));
  }
  return report;
}

}  // namespace svchain
